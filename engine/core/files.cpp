#include "core/files.h"

#include "core/error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

constexpr char const* CHOOSE_ANOTHER = "choose another output folder";

[[noreturn]] void fail(std::string const& what, fs::path const& path, int error, std::string const& advice) {
    throw Error(ErrorKind::bad_input, what + ": " + std::strerror(error), path.string(), advice);
}

[[noreturn]] void fail_to_read(fs::path const& path, int error) {
    fail("can't be read", path, error, error == EACCES ? "change its permissions" : "check the path");
}

[[noreturn]] void fail_to_write(fs::path const& path, int error) {
    bool const full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    fail("can't be written", path, error, full ? "free some space, or choose another output folder" : CHOOSE_ANOTHER);
}

struct Descriptor {
    int value;
    explicit Descriptor(int v) : value(v) {}
    ~Descriptor() { close(); }
    /// 0, or the errno of what some file systems say only now.
    int close() {
        int const result = value >= 0 ? ::close(std::exchange(value, -1)) : 0;
        return result == 0 ? 0 : errno;
    }
    Descriptor(Descriptor const&) = delete;
    Descriptor& operator=(Descriptor const&) = delete;
};

void write_all(int descriptor, std::span<std::byte const> bytes, fs::path const& path) {
    while (!bytes.empty()) {
        ssize_t const written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_to_write(path, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void make_folder(fs::path const& folder, std::string const& advice) {
    std::error_code error, ignored;
    if (folder.empty() || fs::create_directories(folder, error) || fs::is_directory(folder, ignored)) return;
    throw Error(ErrorKind::bad_input,
                "folder can't be made: " + (error ? error.message() : "something else has this name"), folder.string(),
                advice);
}

std::string environment(char const* name) {
    char const* const value = std::getenv(name);
    return value ? value : "";
}

} // namespace

std::vector<std::byte> read_file(fs::path const& path, std::uint64_t largest) {
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    Descriptor const file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.value < 0) fail_to_read(path, errno);
    struct stat status {};
    if (::fstat(file.value, &status) != 0) fail_to_read(path, errno);
    if (!S_ISREG(status.st_mode))
        throw Error(ErrorKind::bad_input, "is not a regular file", path.string(), "give the path of a file");
    auto const size = static_cast<std::uint64_t>(status.st_size);
    if (size > largest) {
        throw Error(ErrorKind::bad_input,
                    "is " + std::to_string(size) + " bytes, more than the limit of " + std::to_string(largest),
                    path.string(), "is it the right file?");
    }
    std::vector<std::byte> bytes(size);
    std::size_t done = 0;
    while (done < bytes.size()) {
        ssize_t const got = ::read(file.value, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_to_read(path, errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

std::string read_text_file(fs::path const& path, std::uint64_t largest) {
    std::vector<std::byte> const bytes = read_file(path, largest);
    return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

void write_file(fs::path const& path, std::span<std::byte const> bytes) {
    make_folder(path.parent_path(), CHOOSE_ANOTHER);
    fs::path temporary = path;
    temporary += ".part" + std::to_string(::getpid());
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (file.value < 0) fail_to_write(path, errno);
    try {
        write_all(file.value, bytes, path);
        if (int const error = file.close()) fail_to_write(path, error);
        if (::rename(temporary.c_str(), path.c_str()) != 0) fail_to_write(path, errno);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
}

void write_text_file(fs::path const& path, std::string const& text) {
    write_file(path, std::as_bytes(std::span(text)));
}

void require_writable_folder(fs::path const& folder, std::string const& advice) {
    make_folder(folder, advice);
    fs::path const probe = folder / (".alpenglow_probe" + std::to_string(::getpid()));
    Descriptor const file(::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    if (file.value < 0) fail("folder can't be written to", folder, errno, advice);
    ::unlink(probe.c_str());
}

fs::path assets_folder() {
    if (std::string const given = environment("ALPENGLOW_ASSETS"); !given.empty()) return given;
    std::error_code error;
    fs::path const program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (fs::path const& candidate :
         {program / "assets", program / "../share/alpenglow/assets", fs::path(ALPENGLOW_SOURCE_ASSETS)}) {
        if (fs::is_directory(candidate / "planets", error)) return candidate.lexically_normal();
    }
    throw Error(ErrorKind::bad_input, "the assets folder was not found", program.string(),
                "set ALPENGLOW_ASSETS to it");
}

fs::path cache_folder() {
    if (std::string const given = environment("ALPENGLOW_CACHE"); !given.empty()) return given;
    if (std::string const xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return fs::path(xdg) / "alpenglow";
    if (std::string const home = environment("HOME"); !home.empty()) return fs::path(home) / ".cache/alpenglow";
    return fs::temp_directory_path() / "alpenglow-cache";
}

} // namespace alpenglow
