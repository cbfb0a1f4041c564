#include "image/exr.h"
#include "support/background_process.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

namespace fs = std::filesystem;

constexpr char const* VIEW = R"({"camera": {"latitude": 46, "longitude": 7.5, "altitude": 900}})";

/// A tiny picture on its way, with what its command is given besides.
std::vector<std::string> tracing(std::string const& out, std::vector<std::string> const& more) {
    std::vector<std::string> arguments{"reference", "view.json", "--size", "16x16", "--threads", "1", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// A folder with the state that an interrupted run left in `out`.
class InterruptedReference : public testing::Test {
protected:
    void SetUp() override {
        folder_.write("view.json", VIEW);
        // More than any machine does before it is looked at.
        std::vector<std::string> command = tracing("out", {"--samples", "1000000000"});
        command.insert(command.begin(), ALPENGLOW_PROGRAM);
        test::BackgroundProcess process(command, {.folder = folder_.path()});
        ASSERT_TRUE(test::wait_until([&] { return fs::exists(state()) || process.exit_code(); }, 120));
        process.interrupt();
        ASSERT_TRUE(test::wait_until([&] { return process.exit_code().has_value(); }, 120));
        EXPECT_EQ(process.exit_code(), 3);
        ASSERT_TRUE(fs::exists(state()));
        EXPECT_FALSE(fs::exists(picture("out")));
    }

    test::ProcessResult run(std::vector<std::string> const& arguments) const {
        return test::run({.program = ALPENGLOW_PROGRAM, .arguments = arguments, .folder = folder_.path()});
    }
    fs::path state() const { return folder_.path() / "out/view.state"; }
    fs::path picture(std::string const& out) const { return folder_.path() / out / "view.exr"; }

    test::TemporaryFolder folder_;
};

} // namespace

TEST_F(InterruptedReference, goes_on_to_the_picture_of_a_run_that_was_not) {
    test::ProcessResult const resumed = run(tracing("out", {"--samples", "1024", "--resume"}));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
    EXPECT_FALSE(fs::exists(state()));
    // 1024, or more where the machine was quick.
    std::string const samples = read_record(picture("out")).attributes.at("samples");
    EXPECT_GE(std::stoi(samples), 1024);
    test::ProcessResult const whole = run(tracing("whole", {"--samples", samples}));
    ASSERT_EQ(whole.exit_code, 0) << whole.errors;
    EXPECT_EQ(read_file(picture("out")), read_file(picture("whole")));

    test::ProcessResult const again = run(tracing("out", {"--samples", "512", "--resume"}));
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(again.output, ""); // nothing was left to do
}

TEST_F(InterruptedReference, does_not_go_on_with_what_is_not_its_own) {
    for (std::vector<std::string> const& other :
         {std::vector<std::string>{"--seed", "2"}, {"--orders", "2"}, {"--sun", "point"}}) {
        std::vector<std::string> arguments = tracing("out", {"--resume"});
        arguments.insert(arguments.end(), other.begin(), other.end());
        test::ProcessResult const result = run(arguments);
        EXPECT_EQ(result.exit_code, 3) << other.front();
        test::expect_error_line(result, {"view.state", "another", "leave --resume out"});
    }
}

TEST_F(InterruptedReference, does_not_go_on_from_a_state_that_is_cut_short) {
    std::vector<std::byte> const bytes = read_file(state());
    auto const recipe = static_cast<std::size_t>(std::ranges::find(bytes, std::byte{0}) - bytes.begin());
    for (std::size_t const size : {bytes.size() - 1, recipe + 40, recipe + 1, recipe, recipe - 1, std::size_t{0}}) {
        write_file(state(), std::span(bytes).first(size));
        test::ProcessResult const result = run(tracing("out", {"--resume"}));
        EXPECT_EQ(result.exit_code, 3) << size;
        EXPECT_EQ(result.signal, 0) << size;
        test::expect_error_line(result, {"view.state"});
    }
}
