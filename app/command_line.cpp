#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/analyzer_text.h"
#include "app/suggestion.h"
#include "app/variant.h"
#include "app/view_text.h"
#include "base/error.h"

namespace brewster {
namespace {

constexpr double bytes_per_gib = 1073741824.0;
constexpr std::uint64_t largest_photon_count = 1'000'000'000'000'000;

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& wish) {
    throw CLI::ValidationError(option, "'" + text + "' is not " + wish);
}

CLI::Option* add_whole_number(CLI::App& verb, const std::string& option, const std::string& what, std::uint64_t least,
                              std::uint64_t largest, const std::function<void(std::uint64_t)>& keep) {
    const auto read = [=](const std::string& text) {
        const std::optional<std::uint64_t> value = parse_whole_number(text);
        if (!value || *value < least || *value > largest) {
            refuse(option, text,
                   "a whole number from " + std::to_string(least) + " to " + std::to_string(largest) +
                       " (written like 20000000 or 2e7)");
        }
        keep(*value);
    };
    return verb.add_option_function<std::string>(option, read, what);
}

CLI::Option* add_number(CLI::App& verb, const std::string& option, const std::string& what, double least,
                        double largest, const std::function<void(double)>& keep) {
    const auto read = [=](const std::string& text) {
        const std::optional<double> value = parse_number(text);
        if (!value || *value < least || *value > largest) {
            refuse(option, text, "a number from " + significant(least) + " to " + significant(largest));
        }
        keep(*value);
    };
    return verb.add_option_function<std::string>(option, read, what);
}

void add_json(CLI::App& verb, bool& json) {
    verb.add_flag("--json", json, "One JSON object on standard output, and nothing else there");
}

void add_scene(CLI::App& verb, std::string& scene) {
    verb.add_option("scene", scene, "A .gltf or .glb file")->required()->type_name("SCENE");
}

void add_settings(CLI::App& verb, std::vector<Setting>& settings) {
    verb.add_option_function<std::vector<std::string>>(
            "--set",
            [&settings](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    const std::optional<Setting> setting = parse_setting(text);
                    if (!setting) refuse("--set", text, "of the form MATERIAL.PROPERTY=VALUE");
                    settings.push_back(*setting);
                }
            },
            "Change a material or lamp of the scene, like 'floor.roughness=0.3'; may be repeated")
        ->type_name("MATERIAL.PROPERTY=VALUE")
        ->allow_extra_args(false);
}

void add_threads_and_seed(CLI::App& verb, unsigned& threads, std::uint64_t& seed) {
    add_whole_number(verb, "--threads", "Threads that trace (default: as many as the machine has)", 1, 1024,
                     [&threads](std::uint64_t count) { threads = static_cast<unsigned>(count); })
        ->type_name("T");
    add_whole_number(verb, "--seed", "Seed of the random numbers (default 1)", 0,
                     std::numeric_limits<std::uint64_t>::max(), [&seed](std::uint64_t key) { seed = key; })
        ->type_name("K");
}

void add_polarization(CLI::App& verb, bool& polarization) {
    verb.add_option_function<std::string>(
            "--polarization",
            [&](const std::string& text) {
                if (text != "on" && text != "off") refuse("--polarization", text, "on or off");
                polarization = text == "on";
            },
            "Off shows light as if no surface could tell polarizations apart (default on)")
        ->type_name("on|off");
}

std::optional<KernelChoice> parse_kernel(const std::string& text) {
    for (const int stokes : {1, 3, 4})
        for (const int bands : {1, 3})
            for (const bool gloss : {false, true})
                if (text == std::to_string(stokes) + "x" + std::to_string(bands) + (gloss ? "-gloss" : ""))
                    return KernelChoice{stokes, bands, gloss};
    return {};
}

/// What everything that traces has in common: when to stop, how to trace.
void add_trace_options(CLI::App& verb, StopRule& stop, EngineSettings& engine, const std::string& default_stop) {
    add_whole_number(verb, "--photons", "Stop after N photons (default: " + default_stop + ")", 1, largest_photon_count,
                     [&](std::uint64_t photons) { stop.photons = photons; })
        ->type_name("N");
    add_number(verb, "--seconds", "Stop after S seconds of tracing (pictures: and drawing)", 1e-3, 1e9,
               [&](double seconds) { stop.seconds = seconds; })
        ->type_name("S");
    add_number(
        verb, "--target-error",
        "Stop at this relative standard error (0.01 is 1 %) of the bins where it is lit (pictures: of their pixels)",
        1e-6, 1, [&](double error) { stop.target_error = error; })
        ->type_name("E");
    add_threads_and_seed(verb, engine.threads, engine.seed);
    verb.add_option_function<std::string>(
            "--kernel",
            [&](const std::string& text) {
                engine.kernel = parse_kernel(text);
                if (!engine.kernel)
                    refuse("--kernel", text,
                           "components x bands like 4x3, with -gloss where gloss is filed, like 4x3-gloss");
            },
            "What photons carry, for measurements: Stokes components 1, 3, 4 and bands 1, 3 (default: what the scene "
            "needs)")
        ->type_name("K");
    add_number(verb, "--memory", "GiB for the bins (default 1)", 1.0 / 64, 4096, [&](double gib) {
        engine.bins.memory_bytes = static_cast<std::size_t>(gib * bytes_per_gib);
    })->type_name("GIB");
}

void add_variant(CLI::App& verb, EngineSettings& engine) {
    std::string list;
    for (const std::string& name : variant_names()) list += (list.empty() ? "" : ", ") + name;
    verb.add_option_function<std::string>(
            "--variant",
            [&engine](const std::string& name) {
                if (!take_variant(name, engine))
                    refuse("--variant", name, "a variant" + did_you_mean(name, variant_names()));
            },
            "Habits of the 1997 method in place of the engine's own, for measurements: " + list)
        ->type_name("NAME");
}

void add_solve_options(CLI::App& verb, SolveOptions& options) {
    add_scene(verb, options.scene);
    add_settings(verb, options.settings);
    add_trace_options(verb, options.stop, options.engine, "1e7");
    add_variant(verb, options.engine);
    add_json(verb, options.json);
}

/// A saved solution brings its settings along, so none of these may be given beside it.
void add_saved(CLI::App& verb, const std::string& option, std::string& path, const std::string& what,
               const std::vector<std::string>& unwanted) {
    CLI::Option* saved = verb.add_option(option, path, what)->type_name("FILE.bins");
    for (const std::string& name : unwanted) saved->excludes(verb.get_option(name));
}

std::vector<Map> parse_maps(const std::vector<std::string>& names) {
    std::vector<Map> maps;
    std::vector<std::string> known = {"all"};
    for (const MapDescription& entry : map_descriptions) known.emplace_back(entry.name);
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            refuse("--map", name, "a map" + did_you_mean(name, known));
        }
        for (const MapDescription& entry : map_descriptions) {
            if (name == entry.name || name == "all") maps.push_back(entry.map);
        }
    }
    return maps;
}

Palette parse_palette(const std::string& name) {
    const std::optional<Palette> palette = find_palette(name);
    std::vector<std::string> known;
    for (const PaletteDescription& entry : palette_descriptions) known.emplace_back(entry.name);
    if (!palette) refuse("--palette", name, "a palette" + did_you_mean(name, known));
    return *palette;
}

std::string map_list() {
    std::string list;
    for (const MapDescription& entry : map_descriptions) list += std::string(entry.name) + ", ";
    return list + "or all";
}

void add_size(CLI::App& verb, std::optional<PictureSize>& size) {
    verb.add_option_function<std::string>(
            "--size",
            [&size](const std::string& text) {
                size = parse_size(text);
                if (!size) {
                    refuse("--size", text,
                           "a size like 640x480, each side from 1 to " + std::to_string(largest_picture_side));
                }
            },
            "Pixels (default: " + std::to_string(default_picture_height) + " rows, columns by the camera's shape)")
        ->type_name("WxH");
}

/// How linear light is shown: maps, palette, analyzer.
void add_rendition(CLI::App& verb, std::vector<Map>& maps, Palette& palette, Analyzer& analyzer) {
    verb.add_option_function<std::vector<std::string>>(
            "--map", [&](const std::vector<std::string>& names) { maps = parse_maps(names); },
            "What to show: " + map_list() + " (default " + std::string(map_descriptions.front().name) +
                "); may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_option_function<std::string>(
            "--analyzer",
            [&](const std::string& text) {
                const std::optional<Analyzer> wished = parse_analyzer(text);
                if (!wished) refuse("--analyzer", text, "an angle in degrees, right, left or none");
                analyzer = *wished;
            },
            "A filter in front of the camera: a polarizer at an angle from the horizontal, counter-clockwise, or a "
            "circular one (default none)")
        ->type_name("DEG|right|left|none");
    verb.add_option_function<std::string>(
            "--palette", [&](const std::string& name) { palette = parse_palette(name); },
            "Colours of the maps: blue-orange (safe for the colour-blind), red-green or polanalyser (default "
            "blue-orange)")
        ->type_name("NAME");
}

void add_exposure(CLI::App& verb, std::optional<double>& exposure, const std::string& otherwise) {
    add_number(verb, "--exposure", "Stops brighter or darker than 1 cd/m2 = white (default: " + otherwise + ")", -64,
               64, [&exposure](double stops) { exposure = stops; })
        ->type_name("EV");
}

void add_legend(CLI::App& verb, bool& legend) {
    verb.add_option_function<std::string>(
            "--legend",
            [&](const std::string& text) {
                if (text != "on" && text != "off") refuse("--legend", text, "on or off");
                legend = text == "on";
            },
            "The words in the corner of a PNG picture (default on)")
        ->type_name("on|off");
}

/// Runs what reads a text; its Error becomes a refusal of the option.
template <class Read>
void read_words(const std::string& option, const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

void add_views(CLI::App& verb, ShotOptions& options) {
    verb.add_option_function<std::vector<std::string>>(
            "--view",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    read_words("--view", [&] { apply_view(parse_view(text), options); });
            },
            "A picture in words: camera, eye, target, up (x,y,z), fov, size, ev, map, palette, analyzer, polarization, "
            "gather, samples, seed, each key=value; other options of the command line outweigh it; may be repeated")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    verb.add_option_function<std::string>(
            "--views",
            [&](const std::string& path) {
                read_words("--views", [&] {
                    for (const View& view : read_views(path)) apply_view(view, options);
                });
            },
            "A file with one view a line, for many pictures from one solution")
        ->type_name("FILE");
}

void add_shot_options(CLI::App& verb, ShotOptions& options) {
    add_views(verb, options);  // first: what is read later outweighs it
    add_solve_options(verb, options.solve);
    add_saved(verb, "--from", options.solve.resume, "Draw a solution that was kept by solve --save; its settings hold",
              {"--set", "--seed", "--memory", "--kernel", "--variant", "--photons", "--seconds", "--target-error"});
    verb.add_option("--camera", options.cameras, "A camera of the scene, or all (default all); may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    add_size(verb, options.size);
    add_rendition(verb, options.maps, options.palette, options.analyzer);
    add_exposure(verb, options.exposure, "fits the first camera");
    add_whole_number(
        verb, "--samples",
        "Draws for each pixel, on the mean, that a picture is made of (default 64; what --seconds and --target-error "
        "need)",
        1, 1 << 20, [&](std::uint64_t samples) { options.samples = static_cast<int>(samples); })
        ->type_name("J");
    add_polarization(verb, options.polarization);
    verb.add_option_function<std::string>(
            "--gather",
            [&](const std::string& text) {
                if (text != "on" && text != "off") refuse("--gather", text, "on or off");
                options.gather = text == "on";
            },
            "On follows rays from the eye that end in the bins: crisp light, gloss of any width, mirrors, glass; off "
            "shows the bins alone (default on)")
        ->type_name("on|off");
    add_legend(verb, options.legend);
    verb.add_flag("--ground-truth", options.ground_truth,
                  "EXR pictures also hold I0, I45, I90, I135, normals, positions, depth and material, and cameras.json "
                  "the cameras");
    verb.add_option("--out", options.out,
                    "Where to, .png or .exr, with {camera} and {map} filled in (default " + options.out + ")")
        ->type_name("FILE");
}

/// Pixels of some meshes only; `what` shows them.
void add_region(CLI::App& verb, std::string& scene, std::string& camera, std::vector<std::string>& regions,
                const std::string& what) {
    CLI::Option* scene_option =
        verb.add_option("--scene", scene, "The scene of " + what + ", for --region")->type_name("SCENE");
    CLI::Option* camera_option =
        verb.add_option("--camera", camera, "The camera of " + what + ", for --region")->type_name("NAME");
    verb.add_option("--region", regions, "Only pixels that show nothing but these meshes")
        ->type_name("MESH,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->needs(scene_option)
        ->needs(camera_option);
}

void add_develop_options(CLI::App& verb, DevelopOptions& options) {
    verb.add_option("picture", options.picture, "An EXR picture of linear light")->required()->type_name("PICTURE.exr");
    add_rendition(verb, options.maps, options.palette, options.analyzer);
    add_exposure(verb, options.exposure, "the file's, else fits the picture");
    add_legend(verb, options.legend);
    add_region(verb, options.scene, options.camera, options.regions, "the picture");
    verb.add_option("--out", options.out,
                    "Where to, .png, with {camera} and {map} filled in (default " + options.out + ")")
        ->type_name("FILE");
    add_json(verb, options.json);
    verb.footer("Example: brewster develop front.exr --map dolp --map aolp --analyzer 30 --out 'front-{map}.png'");
}

void add_compare_options(CLI::App& verb, CompareOptions& options) {
    verb.add_option("picture", options.picture, "An EXR picture")->required()->type_name("A.exr");
    verb.add_option("reference", options.reference, "What it is measured against, of the same size")
        ->required()
        ->type_name("B.exr");
    add_region(verb, options.scene, options.camera, options.regions, "both pictures");
    add_whole_number(verb, "--block", "Compare means over blocks of so many pixels a side (default 1)", 1, 4096,
                     [&](std::uint64_t side) { options.block = static_cast<int>(side); })
        ->type_name("N");
    add_number(verb, "--epsilon", "Share of the mean below which errors are relative to that share (default 0.01)",
               1e-6, 1e6, [&](double epsilon) { options.epsilon = epsilon; })
        ->type_name("E");
    verb.add_option("--out", options.out,
                    "Write the difference, .exr, or .png: orange where the picture is brighter, blue where darker")
        ->type_name("FILE");
    add_number(verb, "--full-scale", "Relative difference of full colour in a .png (default 0.1)", 1e-6, 1e6,
               [&](double full) { options.full_scale = full; })
        ->type_name("X");
    add_json(verb, options.json);
    verb.footer("Example: brewster compare front.exr reference.exr --block 8 --out difference.png");
}

void add_reference_options(CLI::App& verb, ReferenceOptions& options) {
    add_scene(verb, options.scene);
    add_settings(verb, options.settings);
    verb.add_option("--camera", options.camera, "A camera of the scene (default: its first)")->type_name("NAME");
    add_size(verb, options.size);
    add_whole_number(verb, "--spp",
                     "Samples for each pixel (default " + std::to_string(default_reference_samples) + ")", 1, 1 << 26,
                     [&](std::uint64_t samples) { options.spp = samples; })
        ->type_name("N");
    add_number(verb, "--seconds", "Stop after S seconds of tracing", 1e-3, 1e9, [&](double seconds) {
        options.seconds = seconds;
    })->type_name("S");
    add_polarization(verb, options.polarized);
    add_threads_and_seed(verb, options.threads, options.seed);
    verb.add_option("--out", options.out, "Where to, .exr (default " + options.out + ")")->type_name("FILE");
    add_json(verb, options.json);
}

std::vector<std::string> option_names(const CLI::App& verb) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// The sentence for a command line that CLI11 refused.
std::string complaint(const CLI::App& verb, const CLI::ParseError& failure) {
    std::string text = failure.what();
    const std::vector<std::string> unknown = verb.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&failure) != nullptr && !unknown.empty()) {
        text = "'" + unknown.front() + "' was not expected";
        if (unknown.front().starts_with("-")) text += did_you_mean(unknown.front(), option_names(verb));
    }
    const std::string call = verb.get_parent() == nullptr ? "brewster" : "brewster " + verb.get_name();
    return "brewster: " + text + "\nSee '" + call + " --help'.\n";
}

/// A first word that is neither a verb nor a file is most likely a mistyped verb.
void refuse_unknown_verb(const CLI::App& program, int argc, const char* const* argv) {
    if (argc < 2) return;
    const std::string word = argv[1];
    std::vector<std::string> verbs;
    for (const CLI::App* verb : program.get_subcommands(nullptr)) verbs.push_back(verb->get_name());
    const bool is_verb = std::find(verbs.begin(), verbs.end(), word) != verbs.end();
    if (word.empty() || is_verb || word.find_first_of("-./") != std::string::npos || std::filesystem::exists(word)) {
        return;
    }
    throw CommandLineEnd{"brewster: '" + word + "' is neither a verb nor a file" + did_you_mean(word, verbs) +
                         "\nSee 'brewster --help'.\n"};
}

/// Options of the viewer in front of a verb would be forgotten without a word.
void refuse_words_before_the_verb(const CLI::App& program) {
    for (const CLI::Option* option : program.get_options()) {
        if (option->count() > 0) {
            throw CommandLineEnd{"brewster: " + option->get_name() +
                                 " stands before the verb, where it does nothing\n"};
        }
    }
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
    OpenOptions open;
    SolveOptions solve;
    ShotOptions shot;
    DevelopOptions develop;
    InfoOptions info;
    ReferenceOptions reference;
    CompareOptions compare;

    CLI::App program("Polarized global illumination: photons fill bins on every surface, any camera looks at them.",
                     "brewster");
    program.set_version_flag("--version", "brewster " BREWSTER_VERSION);
    program.footer(
        "Examples:\n"
        "  brewster assets/scenes/cornell-box.gltf\n"
        "  brewster solve assets/scenes/cornell-box.gltf --photons 2e7 --json\n"
        "  brewster shot assets/scenes/cornell-box.gltf --camera all --out 'pictures/{camera}.png'\n"
        "  brewster compare picture.exr reference.exr\n"
        "Exit codes: 0 done, 1 failed (one sentence says why), 2 the command line was wrong.");
    program.add_option("scene", open.scene, "A .gltf or .glb file to look at (default: the Cornell box)")
        ->type_name("SCENE");
    program.add_flag("--headless", open.headless, "Write pictures of all cameras instead of opening a window");
    program.add_option("--replay", open.replay, "Play a script into the window, for tests and measurements")
        ->type_name("FILE");
    program.add_option("--report", open.report, "Where the outcome of --replay goes (default: standard output)")
        ->type_name("FILE");
    program.add_option("--record", open.record, "Write what is done in the window as such a script")->type_name("FILE");
    add_settings(program, open.settings);
    add_trace_options(program, open.stop, open.engine, "never in the window, 1e7 for pictures");

    CLI::App* solve_verb = program.add_subcommand("solve", "Trace photons and report what they found");
    add_solve_options(*solve_verb, solve);
    solve_verb->add_option("--save", solve.save, "Keep the solution in a file, to go on from or to draw")
        ->type_name("FILE.bins")
        ->excludes(solve_verb->get_option("--variant"));
    add_saved(*solve_verb, "--resume", solve.resume,
              "Go on from a kept solution, with so many photons or seconds more; its settings hold",
              {"--set", "--seed", "--memory", "--kernel", "--variant"});
    solve_verb->footer(
        "The first stop that is reached ends the run; Ctrl+C ends it with the photons there are.\n"
        "Example: brewster solve assets/scenes/cornell-box.gltf --target-error 0.02 --threads 2");

    CLI::App* shot_verb = program.add_subcommand("shot", "Trace photons, then write pictures");
    add_shot_options(*shot_verb, shot);
    shot_verb->footer(
        "PNG is what a screen shows; EXR holds linear radiance with its variance, whatever map and exposure are.\n"
        "Example: brewster shot assets/scenes/cornell-box.gltf --camera front --size 512x512 --out front.exr");

    CLI::App* develop_verb =
        program.add_subcommand("develop", "Show a picture of linear light as maps, and say its means");
    add_develop_options(*develop_verb, develop);

    CLI::App* info_verb = program.add_subcommand("info", "Say what a scene holds and what is not simulated");
    add_scene(*info_verb, info.scene);
    add_settings(*info_verb, info.settings);
    add_json(*info_verb, info.json);
    info_verb->footer("Example: brewster info assets/scenes/cornell-box.gltf");

    CLI::App* reference_verb = program.add_subcommand(
        "reference", "Trace single paths, without any bins, into an EXR picture to compare with");
    add_reference_options(*reference_verb, reference);
    reference_verb->footer(
        "Slow and right: S0 to S3 of every band with the variance of each; doubts about a picture end here.\n"
        "Example: brewster reference assets/scenes/cornell-box.gltf --camera front --size 320x240 --seconds 30 --out "
        "ref.exr");

    CLI::App* compare_verb = program.add_subcommand("compare", "Say how far a picture is from a reference");
    add_compare_options(*compare_verb, compare);

    refuse_unknown_verb(program, argc, argv);
    const auto chosen = [&]() -> const CLI::App& {
        const std::vector<CLI::App*> verbs = program.get_subcommands();
        return verbs.empty() ? program : *verbs.front();
    };
    try {
        program.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        throw CommandLineEnd{chosen().help(), 0};
    } catch (const CLI::CallForVersion& version) {
        throw CommandLineEnd{std::string(version.what()) + "\n", 0};
    } catch (const CLI::ParseError& failure) {
        throw CommandLineEnd{complaint(chosen(), failure), 2};
    }

    if (!program.get_subcommands().empty()) refuse_words_before_the_verb(program);

    if (solve_verb->parsed()) return solve;
    if (shot_verb->parsed()) return shot;
    if (develop_verb->parsed()) return develop;
    if (info_verb->parsed()) return info;
    if (reference_verb->parsed()) return reference;
    if (compare_verb->parsed()) return compare;
    return open;
}

}  // namespace brewster
