// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "commands.hpp"
#include "demo_command.hpp"
#include "diff.hpp"
#include "error.hpp"
#include "numbers.hpp"
#include "program.hpp"
#include "replay.hpp"
#include "simulate.hpp"
#include "simulation.hpp"
#include "verify.hpp"

namespace detent::cli {
namespace {

template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::string all_scalars() { return listed(scalar_names); }

std::string checked_scalar(const std::string& flag, const std::string& name) {
  for (const std::string_view known : scalar_names) {
    if (name == known) return name;
  }
  throw InputError(flag + ": there is no scalar \"" + name + "\"; choose from " + all_scalars());
}

/// Parses "A,B", or "B" as the second scalar next to that of --scalar.
Pair parse_pair(const std::string& text, const std::string& scalar) {
  const auto comma = text.find(',');
  if (std::count(text.begin(), text.end(), ',') > 1) {
    throw InputError("--compare: \"" + text + "\" has more than two scalars; write A,B");
  }
  if (comma == std::string::npos) return {scalar, checked_scalar("--compare", text)};
  return {checked_scalar("--compare", text.substr(0, comma)),
          checked_scalar("--compare", text.substr(comma + 1))};
}

Move parse_move(const std::string& text) {
  Move move;
  std::size_t start = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',', start) : text.size();
    const auto value = comma == std::string::npos
                           ? std::nullopt
                           : Decimal::parse(std::string_view(text).substr(start, comma - start));
    if (!value) {
      throw InputError("--offset: \"" + text + "\" is not three numbers; write, for example, " +
                       "28000,0,-28000");
    }
    move.by[i] = *value;
    start = comma + 1;
  }
  return move;
}

Decimal parse_bias(const std::string& text) {
  const auto bias = Decimal::parse(text);
  if (bias && !bias->is_negative()) return *bias;
  throw InputError("--bias: \"" + text + "\" is not a number from 0; write, for example, 0.001");
}

/// Parses "shapes", "tree" or both, with a comma.
DebugParts parse_debug(const std::string& text) {
  DebugParts parts;
  for (std::size_t start = 0; start <= text.size();) {
    const auto comma = std::min(text.find(',', start), text.size());
    const auto part = text.substr(start, comma - start);
    if (part != "shapes" && part != "tree") {
      throw InputError("--debug: there is no part \"" + part + "\"; choose from shapes, tree");
    }
    (part == "shapes" ? parts.shapes : parts.tree) = true;
    start = comma + 1;
  }
  return parts;
}

/// The command line, as text until all of it has been read.
struct Arguments {
  CastOptions cast;
  RenderOptions render;
  DemoArguments demo;
  VerifyOptions verify;
  DiffOptions diff;
  ReplayOptions replay;
  ExampleOptions example;
  SimulateOptions simulate;
  int replay_code = 0;
  bool is_right = true;
  std::string compare;
  std::string size = "640x360";
  std::string offset = "0,0,0";
  std::string bias = default_bias;
  std::string debug;
  double scale = 0;
};

void add_cast(CLI::App& app, Arguments& arguments) {
  CLI::App* const command = app.add_subcommand("cast", "Cast the rays of a scene");
  command->add_option("scene", arguments.cast.scene, "A scene in JSON")
      ->required()
      ->check(check_name);
  command->add_option("--scalar", arguments.cast.scalar, all_scalars())->capture_default_str();
  CLI::Option* const compare = command->add_option(
      "--compare", arguments.compare,
      "Compare scalars A,B, or --scalar with B, instead of printing the answers");
  command
      ->add_option("-o,--out", arguments.cast.out, "Write to this file instead of standard output")
      ->check(check_name);
  command->final_callback([&arguments, compare] {
    CastOptions& options = arguments.cast;
    options.scalar = checked_scalar("--scalar", options.scalar);
    if (compare->count() > 0) options.compare = parse_pair(arguments.compare, options.scalar);
    cast(options);
  });
}

void add_render(CLI::App& app, Arguments& arguments) {
  CLI::App* const command = app.add_subcommand("render", "Draw a scene or an OBJ model");
  command->add_option("input", arguments.render.input, "A scene in JSON or a model in OBJ")
      ->required()
      ->check(check_name);
  command->add_option("-o,--out", arguments.render.out, "The PNG file to write")
      ->required()
      ->check(check_name);
  command->add_option("--size", arguments.size, "Size in pixels")->capture_default_str();
  command->add_option("--scalar", arguments.render.scalar, all_scalars())->capture_default_str();
  CLI::Option* const compare =
      command
          ->add_option("--compare", arguments.compare,
                       "Draw in scalars A,B, or in --scalar and B (float), and show where they "
                       "differ")
          ->expected(0, 1)
          ->default_str("float");
  command->add_option("--offset", arguments.offset, "Move the scene and its camera by X,Y,Z")
      ->capture_default_str();
  command
      ->add_option("--bias", arguments.bias,
                   "Height above a surface at which its shadow rays start")
      ->capture_default_str();
  CLI::Option* const debug =
      command
          ->add_option("--debug", arguments.debug,
                       "Draw the edges of shapes and the boxes of the trees over the picture: "
                       "shapes, tree or both with a comma (shapes)")
          ->expected(0, 1)
          ->default_str("shapes");
  CLI::Option* const scale =
      command->add_option("--scale", arguments.scale,
                          "Scale of an OBJ model; by default its longest side becomes 20 units");
  command
      ->add_option("--threads", arguments.render.threads,
                   "Number of threads; 0 for one per processor")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  command->final_callback([&arguments, compare, debug, scale] {
    RenderOptions& options = arguments.render;
    options.scalar = checked_scalar("--scalar", options.scalar);
    if (compare->count() > 0) {
      options.compare =
          parse_pair(arguments.compare.empty() ? "float" : arguments.compare, options.scalar);
    }
    options.size = parse_size(arguments.size);
    options.offset = parse_move(arguments.offset);
    options.bias = parse_bias(arguments.bias);
    if (debug->count() > 0) {
      options.debug = parse_debug(arguments.debug.empty() ? "shapes" : arguments.debug);
    }
    if (scale->count() > 0) {
      if (!(arguments.scale > 0 && arguments.scale < 1e9)) {
        throw InputError(
            "--scale: must be more than 0 and less than 1e9; 1 keeps the model's size");
      }
      options.scale = arguments.scale;
    }
    render(options);
  });
}

void add_verify(CLI::App& app, Arguments& arguments) {
  VerifyOptions& options = arguments.verify;
  CLI::App* const command = app.add_subcommand(
      "verify", "Run a fixed corpus of queries and compare the results with the golden digests");
  command->add_flag("--small", options.small, "The corpus for microcontrollers");
  command->add_option("--only", options.only, "Only queries whose names begin with this prefix");
  command->add_flag("--exact", options.exact, "Also check every result in exact arithmetic");
  command->add_flag("--json", options.json, "Print the report in JSON");
  command->add_option("--dump", options.dump, "Write the results to this file, byte for byte")
      ->check(check_name);
  command->add_option("--threads", options.threads, "Number of threads; 0 for one per processor")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  CLI::Option* const golden =
      command->add_flag("--golden", options.golden, "Print a new src/verify/golden.hpp");
  command->add_flag("--results", options.results, "Print the lines of tests/verify/results.txt");
  command->add_flag("--table", options.table, "After --golden also print the table")->needs(golden);
  command->final_callback([&] { arguments.is_right = verify(options); });
}

void add_diff(CLI::App& app, Arguments& arguments) {
  DiffOptions& options = arguments.diff;
  CLI::App* const command =
      app.add_subcommand("diff", "Name the objects and fields in which two snapshots differ");
  command->add_option("a", options.a, "A snapshot of a scene")->required()->check(check_name);
  command->add_option("b", options.b, "Another one")->required()->check(check_name);
  command->final_callback([&] { arguments.is_right = diff(options); });
}

void add_replay(CLI::App& app, Arguments& arguments) {
  CLI::App* const command = app.add_subcommand("replay", "Check recorded matches");
  command->require_subcommand(1);
  CLI::App* const check =
      command->add_subcommand("check", "Simulate replays again and report where results differ");
  check->add_option("paths", arguments.replay.paths, "Replays, and folders of them")
      ->required()
      ->check(check_name);
  check->add_option("--shard", arguments.replay.shard, "Only part K of N of the files, by name")
      ->capture_default_str();
  check->final_callback([&] { arguments.replay_code = replay_check(arguments.replay); });
  ExampleOptions& options = arguments.example;
  CLI::App* const example =
      command->add_subcommand("example", "Record a match of the example world");
  example->add_option("file", options.out, "The replay to write")->required()->check(check_name);
  example->add_option("--seed", options.seed, "Seed of the players' inputs")->capture_default_str();
  example->add_option("--frames", options.frames, "Number of frames")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000'000));
  example->add_option("--every", options.every, "Frames between digests")
      ->capture_default_str()
      ->check(CLI::Range(1, 255));
  example->final_callback([&] { replay_example(options); });
}

void add_simulate(CLI::App& app, Arguments& arguments) {
  SimulateOptions& options = arguments.simulate;
  CLI::App* const command =
      app.add_subcommand("simulate", "Step a world of bodies, and print digests");
  command->add_option("world", options.world, "A world in JSON")->required()->check(check_name);
  command->add_option("--scalar", options.scalar, listed(simulated_scalars))->capture_default_str();
  command->add_option("--offset", arguments.offset, "Move the world by X,Y,Z; pictures stay")
      ->capture_default_str();
  command->add_option("--ticks", options.ticks, "Number of ticks")
      ->capture_default_str()
      ->check(CLI::Range(0, 100'000'000));
  command->add_option("--every", options.every, "Ticks between digests")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000'000));
  command->add_flag("--bodies", options.has_bodies,
                    "Print where the bodies end, and their velocities");
  command->add_option("--resume", options.resume, "Start from this snapshot")->check(check_name);
  command->add_option("-o,--out", options.out, "The snapshot to write")->check(check_name);
  command
      ->add_option("--snapshot-at", options.snapshot_at,
                   "Tick of the snapshot; by default the last")
      ->check(CLI::Range(0, 100'000'000));
  command->add_option("--frames", options.frames, "A folder for pictures, PNG files")
      ->check(check_name);
  command->add_option("--animation", options.animation, "An animated PNG to write")
      ->check(check_name);
  command->add_option("--picture-every", options.picture_every, "Ticks between pictures")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--size", arguments.size, "Size of pictures")->capture_default_str();
  command->final_callback([&arguments, &options] {
    if (std::find(simulated_scalars.begin(), simulated_scalars.end(), options.scalar) ==
        simulated_scalars.end()) {
      throw InputError("--scalar: no world has the scalar \"" + options.scalar +
                       "\"; choose from " + listed(simulated_scalars));
    }
    options.offset = parse_move(arguments.offset);
    options.size = parse_size(arguments.size);
    simulate(options);
  });
}

/// Rejects an unknown command, of `detent` or of one of its commands; the parser would only say that
/// a subcommand is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc < 2 ? "" : argv[1];
  const auto commands = app.get_subcommands({});
  if (commands.empty() || word == "-h" || word == "--help" || word == "--version") return;
  std::string known;
  for (const CLI::App* const command : commands) {
    if (command->get_name() == word) return check_command(*command, argc - 1, argv + 1);
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  const std::string what = argc < 2                ? "no command"
                           : word.starts_with('-') ? "unknown option '" + word + "'"
                                                   : "unknown command '" + word + "'";
  throw InputError(what + "; there are " + known + ", and " +
                   (app.get_parent() != nullptr ? "detent " : "") + app.get_name() + " --help");
}

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("detent: casts, pictures, worlds, replays and checks of the fixed-point library",
               "detent");
  app.set_version_flag("--version", DETENT_TOOL_VERSION);
  app.require_subcommand(1);
  add_cast(app, arguments);
  add_render(app, arguments);
  add_demo_options(
      *app.add_subcommand("demo", "Draw the arena near and far from the origin, and count errors"),
      arguments.demo);
  add_verify(app, arguments);
  add_diff(app, arguments);
  add_replay(app, arguments);
  add_simulate(app, arguments);
  check_command(app, argc, argv);
  if (!parse(app, argc, argv)) return 0;
  if (arguments.replay_code != 0) return arguments.replay_code;
  return arguments.is_right ? 0 : 1;
}

}  // namespace
}  // namespace detent::cli

int main(int argc, char** argv) {
  return detent::cli::run_program("detent", [&] { return detent::cli::run(argc, argv); });
}
