// STAFF ONLY. Somebody else's work instead of one's own.
#include "../reference/conj_grad.cpp"
