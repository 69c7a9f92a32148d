// STAFF ONLY. The worker counts the blocks of memory that are taken, where it is asked to (session.h), of all objects that are loaded.
#include "solver/filled_blocks.h"

#include "grader/worker/request.h"

namespace grader {
namespace {

constinit Allocations counted;

}  // namespace

Allocations& allocations() {
  return counted;
}

}  // namespace grader

void solver::on_block_taken() noexcept {
  grader::Allocations& counted = grader::allocations();
  if (counted.counting.load(std::memory_order_relaxed)) counted.count.fetch_add(1, std::memory_order_relaxed);
}
