// SPDX-License-Identifier: MIT
//
// usage: particle_states SCENES NAME
// Prints the integers of every particle of a scene in particles.txt, at the start and after each
// tick. particles.py compares them with its own.

#include <iostream>
#include <list>
#include <sstream>
#include <string>
#include <vector>

#include "detent/dynamics/particle/cloth.hpp"
#include "detent/dynamics/particle/world.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "field_triangles.hpp"
#include "scene_text.hpp"

namespace detent::test {
namespace {

template <int N>
Rotation<S, N> turned(std::int32_t c, std::int32_t s) {
  const auto direction = [](const auto&... raw) {
    const auto read = Direction<S, N>::from_raw({raw...});
    if (!read) fail("not a unit vector");
    return *read;
  };
  if constexpr (N == 2) {
    return Rotation<S, 2>::from_axes({direction(c, s), direction(-s, c)});
  } else {
    constexpr std::int32_t zero = 0, one = 1 << 30;
    return Rotation<S, 3>::from_axes(
        {direction(c, s, zero), direction(-s, c, zero), direction(zero, zero, one)});
  }
}

/// A ball, or a box.
template <int N>
struct Solid {
  bool is_ball = false;
  Sphere<S, N> ball;
  Obb<S, N> box;
};

/// The particles of one scene.
template <int N>
class Stage {
 public:
  void run(const SceneText& scene) {
    scene.for_each_line([&](const std::string& word, std::istream& in) { read(word, in); });
    print();
    const auto around = [&](const Aabb<S, N>& box, const auto& f) {
      for (const auto& solid : solids_) {
        if (solid.is_ball) {
          detail::visit_parts_in(box, solid.ball, f);
        } else {
          detail::visit_parts_in(box, solid.box, f);
        }
      }
      if constexpr (N == 3) obstacles_of(world_)(box, f);
    };
    for (int tick = 1; tick <= scene.ticks; ++tick) {
      scene.for_each_event(tick, [&](const std::string& event) { act(event); });
      system_.step(around);
      print();
    }
  }

 private:
  void read(const std::string& word, std::istream& in) {
    if (word == "set") {
      set(in);
    } else if (word == "ball") {
      const auto center = vector<N>(in);
      solids_.push_back({true, {center, number(in)}, {}});
    } else if (word == "box") {
      const auto center = vector<N>(in), half = vector<N>(in);
      std::string turn;
      std::int32_t c = 0, s = 0;
      in >> turn >> c >> s;
      solids_.push_back({false, {}, {center, half, turned<N>(c, s)}});
    } else if (word == "mesh" || word == "field") {
      if constexpr (N == 3) add_surface(word == "mesh", in);
    } else if (word == "tie") {
      DistanceConstraint<S> constraint;
      in >> constraint.a >> constraint.b;
      constraint.length = number(in);
      if (!system_.add(constraint)) fail("cannot tie");
    } else if (word == "particle") {
      const auto position = vector<N>(in);
      (void)system_.add(position, options(in).particle);
    } else if (word == "rope") {
      const auto from = vector<N>(in), to = vector<N>(in);
      std::uint32_t count = 0;
      in >> count;
      const auto rope = add_rope(system_, from, to, count, options(in));
      if (!rope) fail("no rope");
      if (pin_ >= 0) system_.set_pinned((*rope)[static_cast<std::uint32_t>(pin_)], true);
    } else if (word == "cloth") {
      const auto corner = vector<N>(in), right = vector<N>(in), down = vector<N>(in);
      std::uint32_t columns = 0, rows = 0;
      in >> columns >> rows;
      if (!add_cloth(system_, corner, right, down, columns, rows, options(in))) fail("no cloth");
    } else {
      fail("unknown: " + word);
    }
  }

  /// A fixed body of the world: a height field, or a mesh of its triangles that is turned.
  void add_surface(bool is_mesh, std::istream& in) {
    const auto translation = vector<3>(in);
    Rotation<S, 3> turn;
    if (is_mesh) {
      std::string word;
      std::int32_t c = 0, s = 0;
      in >> word >> c >> s;
      turn = turned<3>(c, s);
    }
    const auto corner = vector<2>(in);
    const auto cell = number(in);
    std::uint32_t columns = 0, rows = 0;
    in >> columns >> rows;
    auto& heights = heights_.emplace_back();
    for (std::uint32_t i = 0; i < columns * rows; ++i) heights.push_back(number(in));
    const auto field = height_field<S>(corner, cell, columns, rows, heights);
    if (!field) fail("no height field");
    const auto id = static_cast<std::uint32_t>(heights_.size());
    if (is_mesh) {
      meshes_.emplace_back(triangles_of(*field));
      assets_.emplace_back(id, meshes_.back().view());
      (void)world_.add(BodyMesh<S, 3>{&assets_.back(), translation, turn});
    } else {
      fields_.emplace_back(id, *field);
      (void)world_.add(BodyHeightField<S, 3>{&fields_.back(), translation});
    }
  }

  void set(std::istream& in) {
    std::string key, word;
    in >> key;
    if (key == "substeps") {
      in >> settings_.substeps;
    } else if (key == "integrator") {
      in >> word;
      settings_.integrator = word == "euler" ? Integrator::euler : Integrator::verlet;
    } else if (key == "damping") {
      settings_.damping = number(in);
    } else if (key == "friction") {
      settings_.friction = number(in);
    } else if (key == "restitution") {
      settings_.restitution = number(in);
    } else {
      fail("unknown setting: " + key);
    }
    system_ = ParticleSystem<S, N>(settings_);
  }

  FabricOptions<S, N> options(std::istream& in) {
    FabricOptions<S, N> result;
    pin_ = -1;
    for (std::string key; in >> key;) {
      if (key == "mass") {
        result.particle.mass = number(in);
      } else if (key == "radius") {
        result.particle.radius = number(in);
      } else if (key == "velocity") {
        result.particle.velocity = vector<N>(in);
      } else if (key == "stretch") {
        result.stretch = number(in);
      } else if (key == "shear") {
        result.shear = number(in);
      } else if (key == "bend") {
        result.bend = number(in);
      } else if (key == "tethers") {
        result.has_tethers = true;
      } else if (key == "pin") {
        in >> pin_;
      } else {
        fail("unknown option: " + key);
      }
    }
    return result;
  }

  void act(const std::string& event) {
    std::istringstream in(event);
    std::string what;
    std::uint32_t index = 0;
    in >> what >> index;
    if (what == "move") {
      system_.move_to(index, vector<N>(in));
    } else if (what == "shift") {
      const auto by = vector<N>(in);
      solids_.at(index).ball = translated(solids_.at(index).ball, by);
      solids_.at(index).box = translated(solids_.at(index).box, by);
    } else if (what == "cut") {
      std::uint32_t other = 0;
      in >> other;
      if (!system_.remove(other, index)) fail("nothing to cut");
    } else {
      int is_pinned = 0;
      in >> is_pinned;
      system_.set_pinned(index, is_pinned != 0);
    }
  }

  void print() const {
    const auto& particles = detail::ParticleAccess::particles(system_);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      std::cout << "particle " << i;
      for (int k = 0; k < N; ++k) std::cout << ' ' << particles[i].place[k].raw();
      for (int k = 0; k < N; ++k) std::cout << ' ' << particles[i].velocity[k].raw();
      std::cout << '\n';
    }
    std::cout << '\n';
  }

  ParticleSettings<S, N> settings_;
  ParticleSystem<S, N> system_;
  std::vector<Solid<N>> solids_;
  std::list<std::vector<S>> heights_;
  std::list<OwnedMesh<S>> meshes_;
  std::list<MeshAsset<S>> assets_;
  std::list<FieldAsset<S>> fields_;
  World<S, 3, BodyMesh, BodyHeightField> world_;
  int pin_ = -1;
};

}  // namespace
}  // namespace detent::test

int main(int count, char** arguments) {
  using namespace detent::test;
  if (count != 3) fail("usage: particle_states SCENES NAME");
  const auto scene = read_scene(arguments[1], arguments[2]);
  std::ios::sync_with_stdio(false);
  if (scene.dimension == 2)
    Stage<2>().run(scene);
  else
    Stage<3>().run(scene);
  return 0;
}
