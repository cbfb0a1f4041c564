#pragma once

#include "sandbox/stage.h"

#include <gtest/gtest.h>

#include <memory>

namespace alpenglow::test {

/// A test that draws views. All tests of a program share one stage, with validation, because scenes and the tables of the
/// air cost more than pictures: views of one planet and scene are best drawn one after the other.
class StageTest : public testing::Test {
protected:
    static Stage& stage() {
        std::unique_ptr<Stage>& stage = shared();
        if (!stage) {
            testing::AddGlobalTestEnvironment(new End);
            DrawOptions options;
            options.validate = true;
            stage = std::make_unique<Stage>(options);
        }
        return *stage;
    }
    void TearDown() override {
        if (shared()) shared()->require_no_messages();
    }

private:
    /// Takes the device down while the driver's own statics still live.
    struct End : testing::Environment {
        void TearDown() override { shared().reset(); }
    };
    static std::unique_ptr<Stage>& shared() {
        static std::unique_ptr<Stage> stage;
        return stage;
    }
};

} // namespace alpenglow::test
