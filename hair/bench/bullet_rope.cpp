#include "hair/bench/bullet_rope.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace hair_bench {

struct BulletRope::World {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btSoftBody* rope = nullptr;

  ~World() {
    if (!rope) return;
    world.removeSoftBody(rope);
    delete rope;
  }
};

BulletRope::BulletRope(const hair::Strand& strand, int iterations) : world_(std::make_unique<World>()) {
  const btVector3 gravity(0, 0, btScalar(-9.81));
  btSoftBodyWorldInfo& info = world_->world.getWorldInfo();
  info.m_gravity = gravity;
  info.air_density = 0;
  world_->world.setGravity(gravity);

  const int n = strand.count();
  const btVector3 end(btScalar(strand.rest_length.sum()), 0, 0);
  btSoftBody* rope = btSoftBodyHelpers::CreateRope(info, btVector3(0, 0, 0), end, n - 2, 1);
  for (int i = 1; i < n; ++i) rope->setMass(i, btScalar(strand.mass[i]));
  rope->m_cfg.piterations = iterations;
  rope->m_cfg.kDP = 0;
  rope->m_cfg.collisions = 0;
  rope->m_materials[0]->m_kLST = 1;  // as stiff as it goes
  world_->world.addSoftBody(rope);
  world_->rope = rope;
}

BulletRope::~BulletRope() = default;

void BulletRope::step(double h) {
  world_->world.stepSimulation(btScalar(h), 0);
}

Eigen::VectorXd BulletRope::positions() const {
  const auto& nodes = world_->rope->m_nodes;
  Eigen::VectorXd x(3 * nodes.size());
  for (int i = 0; i < nodes.size(); ++i)
    x.segment<3>(3 * i) = Eigen::Vector3d(nodes[i].m_x.x(), nodes[i].m_x.y(), nodes[i].m_x.z());
  return x;
}

}  // namespace hair_bench
