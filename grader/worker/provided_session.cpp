// STAFF ONLY. The session that a provided exercise asks: each of them has its own.
#include "grader/worker/provided.h"

grader::ProvidedSession provided_session = nullptr;
