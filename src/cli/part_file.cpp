// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include <limits.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace detent::cli {
namespace {

/// A path that a signal handler can read at any time, because it is written before `is_set`.
struct Slot {
  std::atomic<bool> is_taken{false};
  std::atomic<bool> is_set{false};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler reads them");

std::array<Slot, 8> slots;  // no command has more than three files open

/// The signal has its default action again, so it ends the program when this returns.
extern "C" void remove_part_files(int signal) {
  for (const Slot& slot : slots) {
    if (slot.is_set.load()) unlink(slot.path.data());
  }
  raise(signal);
}

/// A signal that the caller ignores (nohup) stays ignored.
bool handle_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remove_part_files;
    action.sa_flags = SA_RESETHAND;
    sigaction(signal, &action, nullptr);
  }
  // Then write() reports a file size limit like a full disk.
  return ::signal(SIGXFSZ, SIG_IGN) != SIG_ERR;
}

}  // namespace

PartFile::~PartFile() {
  if (!path_.empty()) unlink(path_.c_str());
  release();
}

void PartFile::own(const std::string& path) {
  [[maybe_unused]] static const bool are_handled = handle_signals();
  release();
  path_ = path;
  if (path.size() >= PATH_MAX) return;  // no file can have this name
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].is_taken.exchange(true)) continue;
    path.copy(slots[i].path.data(), path.size());
    slots[i].path[path.size()] = '\0';
    slots[i].is_set = true;
    slot_ = static_cast<int>(i);
    return;
  }
}

void PartFile::release() {
  if (slot_ >= 0) {
    Slot& slot = slots[static_cast<std::size_t>(slot_)];
    slot.is_set = false;
    slot.is_taken = false;
  }
  slot_ = -1;
  path_.clear();
}

}  // namespace detent::cli
