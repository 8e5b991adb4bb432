// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "context/context.hpp"
#include "polylume/error.hpp"

namespace polylume::test {

/// The contexts of a test program: one per backend, made at the first test that asks, given back
/// after the last.
class GlContexts : public ::testing::Environment {
  public:
    static Context& of(Backend backend) {
        std::unique_ptr<Context>& context = contexts()[backend];
        if (context == nullptr) context = Context::create(backend);
        return *context;
    }
    void TearDown() override { contexts().clear(); }

  private:
    static std::map<Backend, std::unique_ptr<Context>>& contexts() {
        static std::map<Backend, std::unique_ptr<Context>> contexts;
        return contexts;
    }
};

inline ::testing::Environment* const kGlContexts =
    ::testing::AddGlobalTestEnvironment(new GlContexts);

/// The base of every GL test: runs on each backend, with its context current, and ends on "no
/// error".
///
///     class ClearTest : public polylume::test::GlTest {};
///     TEST_P(ClearTest, fillsEveryPixel) { gl().Clear(...); }
///     POLYLUME_ON_EVERY_BACKEND(ClearTest);
///
/// A backend that can't be had fails the test: both are installed wherever tests run. Objects that
/// a test makes have to be gone at its end, since the context lives on.
class GlTest : public ::testing::TestWithParam<Backend> {
  protected:
    void SetUp() override {
        try {
            context_ = &GlContexts::of(GetParam());
            context_->makeCurrent();
        } catch (const ContextError& error) {
            FAIL() << error.what();
        }
    }

    void TearDown() override {
        if (context_ == nullptr) return;
        try {
            // The test may have used another context.
            context_->makeCurrent();
            context_->debugLog().checkNoErrors("at the end of the test");
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }

    Context& context() { return *context_; }
    const gl::Functions& gl() const { return context_->functions(); }

  private:
    Context* context_ = nullptr;
};

inline std::string backendName(const ::testing::TestParamInfo<Backend>& info) {
    return info.param == Backend::egl ? "egl" : "osmesa";
}

}  // namespace polylume::test

/// Runs the TEST_P of a suite on both backends: "ClearTest.fillsEveryPixel/egl".
#define POLYLUME_ON_EVERY_BACKEND(Suite)                                                   \
    INSTANTIATE_TEST_SUITE_P(                                                              \
        , Suite, ::testing::Values(::polylume::Backend::egl, ::polylume::Backend::osmesa), \
        ::polylume::test::backendName)
