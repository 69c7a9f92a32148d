// STAFF ONLY. Somebody else's work instead of one's own.
#include "../reference/S1/conj_grad.cpp"
