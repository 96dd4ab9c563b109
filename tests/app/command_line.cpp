#include "app/command_line.h"

#include <gtest/gtest.h>

#include "app/analyzer_text.h"

namespace brewster {
namespace {

Command parse(std::vector<const char*> words) {
    words.insert(words.begin(), "brewster");
    return parse_command_line(static_cast<int>(words.size()), words.data());
}

/// The text and exit code where the arguments lead to no command.
CommandLineEnd end_of(const std::vector<const char*>& words) {
    try {
        parse(words);
    } catch (const CommandLineEnd& end) {
        return end;
    }
    ADD_FAILURE() << "these arguments were accepted";
    return {};
}

TEST(CommandLine, SolveTakesItsOptions) {
    const auto options = std::get<SolveOptions>(parse({"solve", "box.gltf", "--photons", "2e7", "--threads", "2",
                                                       "--seed", "18446744073709551615", "--memory", "0.5", "--json"}));
    EXPECT_EQ(options.scene, "box.gltf");
    EXPECT_EQ(options.stop.photons, 20000000u);
    EXPECT_FALSE(options.stop.seconds);
    EXPECT_EQ(options.engine.threads, 2u);
    EXPECT_EQ(options.engine.seed, 18446744073709551615u);
    EXPECT_EQ(options.engine.bins.memory_bytes, std::size_t{1} << 29);
    EXPECT_TRUE(options.json);
}

TEST(CommandLine, StopsAreTaken) {
    const StopRule stop = std::get<SolveOptions>(parse({"solve", "box.gltf", "--seconds", "3"})).stop;
    EXPECT_FALSE(stop.photons);
    EXPECT_EQ(stop.seconds, 3.0);
    EXPECT_EQ(std::get<ShotOptions>(parse({"shot", "box.gltf", "--target-error", "0.01"})).solve.stop.target_error,
              0.01);
}

TEST(CommandLine, VariantsChangeWhatTheyName) {
    const auto all = std::get<SolveOptions>(parse({"solve", "box.gltf", "--variant", "thesis-all"})).engine;
    EXPECT_TRUE(all.bins.constant_cells && all.bins.half_differences && all.thesis.sampler && all.thesis.analog);
    EXPECT_FALSE(all.bins.join_corners);
    const auto one = std::get<ShotOptions>(parse({"shot", "box.gltf", "--variant", "thesis-splits"})).solve.engine;
    EXPECT_TRUE(one.bins.half_differences && one.bins.join_corners);
    EXPECT_FALSE(one.bins.constant_cells || one.thesis.any());
    EXPECT_NE(end_of({"solve", "box.gltf", "--variant", "thesis-cell"}).text.find("did you mean 'thesis-cells'"),
              std::string::npos);
    EXPECT_EQ(end_of({"solve", "box.gltf", "--variant", "thesis-all", "--save", "a.bins"}).exit_code, 2);
}

TEST(CommandLine, ShotTakesItsOptions) {
    const auto options = std::get<ShotOptions>(
        parse({"shot", "--camera", "front", "box.gltf", "--camera", "low", "--size", "320x200", "--exposure", "-2.5",
               "--samples", "8", "--legend", "off", "--map", "radiance", "--out", "{camera}.exr"}));
    EXPECT_EQ(options.solve.scene, "box.gltf");
    EXPECT_EQ(options.cameras, (std::vector<std::string>{"front", "low"}));
    ASSERT_TRUE(options.size);
    EXPECT_EQ(options.size->width, 320);
    EXPECT_EQ(options.size->height, 200);
    EXPECT_EQ(options.exposure, -2.5);
    EXPECT_EQ(options.samples, 8);
    EXPECT_FALSE(options.legend);
    EXPECT_EQ(options.maps, (std::vector<Map>{Map::radiance}));
    EXPECT_EQ(options.analyzer, Analyzer{});
    EXPECT_EQ(options.out, "{camera}.exr");
}

TEST(CommandLine, ShotTakesMapsAndAnalyzers) {
    const auto options =
        std::get<ShotOptions>(parse({"shot", "box.gltf", "--map", "dolp", "--map", "aolp", "--analyzer", "-22.5",
                                     "--palette", "red-green", "--polarization", "off"}));
    EXPECT_EQ(options.maps, (std::vector<Map>{Map::dolp, Map::aolp}));
    EXPECT_EQ(options.analyzer, (Analyzer{Analyzer::Kind::linear, -22.5}));
    EXPECT_EQ(options.palette, Palette::red_green);
    EXPECT_FALSE(options.polarization);
    EXPECT_EQ(std::get<ShotOptions>(parse({"shot", "box.gltf", "--map", "all"})).maps.size(), map_descriptions.size());
    EXPECT_EQ(std::get<ShotOptions>(parse({"shot", "box.gltf", "--analyzer", "left"})).analyzer.kind,
              Analyzer::Kind::left);
    EXPECT_NE(end_of({"shot", "box.gltf", "--map", "dollp"}).text.find("did you mean 'dolp'"), std::string::npos);
}

TEST(CommandLine, OtherOptionsOutweighAView) {
    const auto options = std::get<ShotOptions>(
        parse({"shot", "box.gltf", "--map", "s2", "--seed", "5", "--view", "map=dolp seed=3 analyzer=30 camera=low"}));
    EXPECT_EQ(options.maps, (std::vector<Map>{Map::s2}));
    EXPECT_EQ(options.solve.engine.seed, 5u);
    EXPECT_EQ(options.analyzer.angle, 30);
    ASSERT_EQ(options.views.size(), 1u);
    EXPECT_EQ(options.views[0].camera, "low");
    EXPECT_NE(end_of({"shot", "box.gltf", "--view", "mapp=dolp"}).text.find("did you mean"), std::string::npos);
}

TEST(CommandLine, DevelopTakesItsOptions) {
    const auto options = std::get<DevelopOptions>(
        parse({"develop", "a.exr", "--map", "dolp", "--exposure", "2", "--analyzer", "right", "--legend", "off"}));
    EXPECT_EQ(options.picture, "a.exr");
    EXPECT_EQ(options.maps, (std::vector<Map>{Map::dolp}));
    EXPECT_EQ(options.exposure, 2);
    EXPECT_EQ(options.analyzer.kind, Analyzer::Kind::right);
    EXPECT_FALSE(options.legend);
    EXPECT_EQ(end_of({"develop", "a.exr", "--region", "floor"}).exit_code, 2);
}

TEST(AnalyzerText, ReadsWhatItWrites) {
    for (const Analyzer& analyzer : {Analyzer{}, Analyzer{Analyzer::Kind::linear, 0.1}, Analyzer{Analyzer::Kind::right},
                                     Analyzer{Analyzer::Kind::left}, Analyzer{Analyzer::Kind::linear, -1e-7}})
        EXPECT_EQ(parse_analyzer(analyzer_text(analyzer)), analyzer);
    for (const char* text : {"", "up", "30deg", "nan", "inf"}) EXPECT_FALSE(parse_analyzer(text)) << text;
}

TEST(CommandLine, OtherVerbs) {
    EXPECT_TRUE(std::get<InfoOptions>(parse({"info", "box.gltf", "--json"})).json);
    const auto compare = std::get<CompareOptions>(parse({"compare", "a.exr", "b.exr"}));
    EXPECT_EQ(compare.picture, "a.exr");
    EXPECT_EQ(compare.reference, "b.exr");
    EXPECT_EQ(std::get<OpenOptions>(parse({})).scene, "");
    const auto open = std::get<OpenOptions>(parse({"--headless", "box.gltf"}));
    EXPECT_EQ(open.scene, "box.gltf");
    EXPECT_TRUE(open.headless);
    EXPECT_EQ(std::get<OpenOptions>(parse({"--threads", "1"})).engine.threads, 1u);
}

TEST(CommandLine, ReferenceTakesItsOptions) {
    const auto options = std::get<ReferenceOptions>(
        parse({"reference", "box.gltf", "--camera", "front", "--size", "32x24", "--spp", "1e3", "--polarization", "off",
               "--seed", "5", "--threads", "2", "--out", "ref.exr", "--json"}));
    EXPECT_EQ(options.camera, "front");
    EXPECT_EQ(options.size->width, 32);
    EXPECT_EQ(options.spp, 1000u);
    EXPECT_FALSE(options.seconds);
    EXPECT_FALSE(options.polarized);
    EXPECT_EQ(options.seed, 5u);
    EXPECT_EQ(options.threads, 2u);
    EXPECT_EQ(options.out, "ref.exr");
    EXPECT_TRUE(options.json);
    EXPECT_TRUE(std::get<ReferenceOptions>(parse({"reference", "box.gltf"})).polarized);
    EXPECT_EQ(end_of({"reference", "box.gltf", "--polarization", "maybe"}).exit_code, 2);
}

TEST(CommandLine, HelpAndVersionEndWell) {
    EXPECT_EQ(end_of({"--version"}).exit_code, 0);
    EXPECT_EQ(end_of({"--version"}).text.rfind("brewster ", 0), 0u);
    for (const std::vector<const char*>& words : std::vector<std::vector<const char*>>{
             {"--help"}, {"solve", "--help"}, {"shot", "--help"}, {"info", "--help"}, {"compare", "--help"}}) {
        const CommandLineEnd end = end_of(words);
        EXPECT_EQ(end.exit_code, 0);
        EXPECT_NE(end.text.find("brewster"), std::string::npos) << end.text;
        EXPECT_NE(end.text.find("Example"), std::string::npos) << end.text;
    }
    EXPECT_NE(end_of({"shot", "--help"}).text.find("--camera"), std::string::npos);
}

TEST(CommandLine, BadValuesAreRefusedByName) {
    const std::vector<std::pair<const char*, const char*>> bad = {
        {"--photons", "1.5"}, {"--photons", "1e30"},    {"--photons", "0"},      {"--photons", "-1"},
        {"--seconds", "0"},   {"--seconds", "soon"},    {"--target-error", "2"}, {"--threads", "0"},
        {"--threads", "1e6"}, {"--seed", "1.5"},        {"--memory", "nan"},     {"--size", "640"},
        {"--samples", "0"},   {"--exposure", "bright"}, {"--legend", "maybe"},   {"--map", "heat"},
        {"--analyzer", "up"}, {"--palette", "rainbow"}};
    for (const auto& [option, value] : bad) {
        const CommandLineEnd end = end_of({"shot", "box.gltf", option, value});
        EXPECT_EQ(end.exit_code, 2) << option << ' ' << value;
        EXPECT_NE(end.text.find(option), std::string::npos) << end.text;
        EXPECT_NE(end.text.find(value), std::string::npos) << end.text;
    }
}

TEST(CommandLine, NearMissesAreSuggested) {
    EXPECT_NE(end_of({"sovle", "box.gltf"}).text.find("did you mean 'solve'"), std::string::npos);
    EXPECT_NE(end_of({"shto"}).text.find("did you mean 'shot'"), std::string::npos);
    EXPECT_NE(end_of({"solve", "box.gltf", "--photon", "10"}).text.find("did you mean '--photons'"), std::string::npos);
    EXPECT_NE(end_of({"shot", "box.gltf", "--map", "radiace"}).text.find("did you mean 'radiance'"), std::string::npos);
}

TEST(CommandLine, IncompleteAndSuperfluousArgumentsAreRefused) {
    EXPECT_EQ(end_of({"solve"}).exit_code, 2);
    EXPECT_EQ(end_of({"compare", "a.exr"}).exit_code, 2);
    EXPECT_EQ(end_of({"solve", "a.gltf", "b.gltf"}).exit_code, 2);
    EXPECT_EQ(end_of({"solve", "box.gltf", "--photons"}).exit_code, 2);
    EXPECT_EQ(end_of({"a.gltf", "b.gltf"}).exit_code, 2);
    EXPECT_NE(end_of({"--seed", "2", "solve", "box.gltf"}).text.find("before the verb"), std::string::npos);
}

}  // namespace
}  // namespace brewster
