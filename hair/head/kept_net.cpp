#include "hair/head/kept_net.h"

#include <cstring>
#include <string>
#include <string_view>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/digest.h"
#include "hair/io/files/kept_file.h"
#include "hair/strand/variation.h"

namespace hair {

namespace {

constexpr KeptKind kKind{"hairlab: a surface net, format 2", ".net"};

// Digests the solid's values at random places of its box.
std::string key_of(const Solid& solid, int cells) {
  constexpr int kLooks = 2000;
  const Eigen::AlignedBox3d box = solid.box();
  Digest digest;
  digest.add(Vector3d(box.min())).add(Vector3d(box.max())).add(cells);
  Variation variation(1);
  for (int look = 0; look < kLooks; ++look) {
    Vector3d at;
    for (int k = 0; k < 3; ++k) at[k] = variation.uniform(box.min()[k], box.max()[k]);
    const Surface surface = solid.surface_at(at);
    digest.add(surface.distance).add(surface.normal);
  }
  return digest.text();
}

// Appends numbers in this machine's format.
template <class T>
void put(const std::vector<T>& values, std::string& bytes) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size());
}

template <class T>
bool take(std::string_view& bytes, std::vector<T>& values) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  values.resize(count);
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), sizeof(T) * count);
  bytes.remove_prefix(sizeof(T) * count);
  return true;
}

std::optional<SurfaceMesh> mesh_of(std::string_view bytes) {
  SurfaceMesh mesh;
  if (!take(bytes, mesh.points) || !take(bytes, mesh.normals) || !take(bytes, mesh.triangles) ||
      !bytes.empty())
    return {};
  return mesh;
}

}  // namespace

SurfaceMesh kept_surface_net(const Solid& solid, int cells,
                             const std::optional<std::filesystem::path>& folder) {
  if (!folder) return surface_net(solid, cells);
  const std::string key = key_of(solid, cells);
  if (const auto bytes = find_kept(*folder, kKind, key))
    if (std::optional<SurfaceMesh> kept = mesh_of(*bytes)) return std::move(*kept);
  SurfaceMesh mesh = surface_net(solid, cells);
  std::string bytes;
  put(mesh.points, bytes);
  put(mesh.normals, bytes);
  put(mesh.triangles, bytes);
  try {
    keep(*folder, kKind, key, bytes);
  } catch (const BadInput&) {
    // The next run makes the mesh again.
  }
  return mesh;
}

}  // namespace hair
