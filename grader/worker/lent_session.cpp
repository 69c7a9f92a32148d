// STAFF ONLY. The session that a lent exercise asks: each of them has its own.
#include "grader/worker/lent_objects.h"

grader::LentSession lent_session = nullptr;
