// SPDX-License-Identifier: MIT
//
// The samples for a page, one at a time. Numbers and texts are returned as pointers into the
// module's memory.
#include "gallery.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace {

std::unique_ptr<samples::Sample> running;
samples::Picture picture;
std::array<float, 16> view_matrix;
std::string text;

const samples::Entry& entry(std::size_t i) { return *samples::gallery()[i]; }

}  // namespace

EXPORT(count) std::size_t count() { return samples::gallery().size(); }
EXPORT(name) const char* name(std::size_t i) { return entry(i).name; }
EXPORT(sentence) const char* sentence(std::size_t i) { return entry(i).sentence; }
EXPORT(keys) const char* keys(std::size_t i) { return entry(i).keys; }

/// Restarts a sample.
EXPORT(start) void start(std::size_t i) {
  running.reset();
  running = entry(i).make();
}
/// Steps a tick with the player's input; x and y are ignored if `is_pointing` is 0.
EXPORT(step) void step(std::uint8_t held, int is_pointing, std::int16_t x, std::int16_t y) {
  running->step({held, is_pointing != 0, x, y});
}
EXPORT(digest) std::uint64_t digest() { return running->digest(); }
EXPORT(status) const char* status() {
  text = running->status();
  return text.c_str();
}

/// Draws the sample into the vertices of `triangles` and `lines`, 16 bytes each.
EXPORT(draw) void draw() {
  picture.clear();
  running->draw(picture);
}
EXPORT(triangles) const samples::Vertex* triangles() { return picture.triangles.data(); }
EXPORT(triangle_vertices) std::size_t triangle_vertices() { return picture.triangles.size(); }
EXPORT(lines) const samples::Vertex* lines() { return picture.lines.data(); }
EXPORT(line_vertices) std::size_t line_vertices() { return picture.lines.size(); }
EXPORT(matrix) const float* matrix(float aspect) {
  view_matrix = samples::matrix(running->view(), aspect);
  return view_matrix.data();
}
