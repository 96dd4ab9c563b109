#include <cstdio>
#include <exception>
#include <new>
#include <type_traits>

#include "app/command_line.h"
#include "app/verbs.h"

namespace {

enum ExitCode { done = 0, failed = 1 };

void run(const brewster::Command& command) {
    std::visit(
        [](const auto& options) {
            using Options = std::decay_t<decltype(options)>;
            if constexpr (std::is_same_v<Options, brewster::SolveOptions>) brewster::solve(options);
            if constexpr (std::is_same_v<Options, brewster::ShotOptions>) brewster::shot(options);
            if constexpr (std::is_same_v<Options, brewster::DevelopOptions>) brewster::develop(options);
            if constexpr (std::is_same_v<Options, brewster::InfoOptions>) brewster::info(options);
            if constexpr (std::is_same_v<Options, brewster::ReferenceOptions>) brewster::make_reference(options);
            if constexpr (std::is_same_v<Options, brewster::CompareOptions>) brewster::compare_pictures(options);
            if constexpr (std::is_same_v<Options, brewster::OpenOptions>) brewster::open_scene(options);
        },
        command);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(brewster::parse_command_line(argc, argv));
        return done;
    } catch (const brewster::CommandLineEnd& end) {
        std::fputs(end.text.c_str(), end.exit_code == done ? stdout : stderr);
        return end.exit_code;
    } catch (const std::bad_alloc&) {
        std::fputs("brewster: out of memory; give the bins less with --memory, or close other programs\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "brewster: %s\n", error.what());
    }
    return failed;
}
