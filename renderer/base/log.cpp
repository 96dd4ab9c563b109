#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

namespace brewster {
namespace {

spdlog::logger& logger() {
    static const std::shared_ptr<spdlog::logger> instance = [] {
        auto made =
            std::make_shared<spdlog::logger>("brewster", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        made->set_pattern("%^%l%$: %v");
        return made;
    }();
    return *instance;
}

}  // namespace

void log_info(std::string_view message) {
    logger().info("{}", message);
}
void log_warning(std::string_view message) {
    logger().warn("{}", message);
}
void log_only_warnings() {
    logger().set_level(spdlog::level::warn);
}

}  // namespace brewster
