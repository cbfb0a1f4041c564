#include "core/error.h"
#include "sandbox/command_line.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace alpenglow;

template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };

int run(Command const& command) {
    return std::visit(
        Overloaded{[](TextToPrint const& o) {
                       std::fputs(o.text.c_str(), stdout);
                       return 0;
                   },
                   [](FlyOptions const& o) { return fly(o); }, [](RenderOptions const& o) { return render(o); },
                   [](StudioOptions const& o) { return studio(o); }, [](ReferenceOptions const& o) { return reference(o); },
                   [](TerrainCommandOptions const& o) { return terrain(o); },
                   [](ScenesOptions const& o) { return scenes(o); },
                   [](BenchOptions const& o) { return bench(o); }, [](CompareOptions const& o) { return compare(o); },
                   [](EvaluateOptions const& o) { return evaluate(o); },
                   [](ShaftsOptions const& o) { return shafts(o); },
                   [](InspectOptions const& o) { return inspect(o); },
                   [](DevicesOptions const& o) { return devices(o); }},
        command);
}

/// A wrong setting is found here, before anything is loaded.
void check_overrides(Command const& command) {
    std::visit(
        [](auto const& options) {
            if constexpr (requires { options.overrides; }) {
                Settings settings;
                apply_overrides(settings, options.overrides);
            }
        },
        command);
}

/// What was printed may still wait in a buffer.
void require_printed() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw Error(ErrorKind::bad_input, std::string("can't be written: ") + std::strerror(errno), "standard output",
                "free some space, or write elsewhere");
}

int report(char const* line, int exit_code) {
    std::fprintf(stderr, "alpenglow: %s\n", line);
    return exit_code;
}

} // namespace

int main(int argc, char** argv) {
    try {
        Command const command = parse_command_line(std::vector<std::string>(argv + 1, argv + argc));
        check_overrides(command);
        int const exit_code = run(command);
        require_printed();
        return exit_code;
    } catch (Error const& error) {
        return report(error.what(), error.exit_code());
    } catch (std::bad_alloc const&) {
        return report("out of memory (use a smaller --size or scene)", static_cast<int>(ErrorKind::bad_input));
    } catch (std::exception const& error) {
        Error const line(ErrorKind::bad_input, error.what());
        return report(line.what(), line.exit_code());
    }
}
