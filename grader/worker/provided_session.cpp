// STAFF ONLY. Defines the session of a provided exercise: each exercise has its own.
#include "grader/worker/provided.h"

grader::ProvidedSession provided_session = nullptr;
