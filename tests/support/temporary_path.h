#pragma once

#include <gtest/gtest.h>

#include <string>

/// A path for a file or folder of the running test alone: tests run side by side.
inline std::string temporaryPath(const std::string& name) {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    return testing::TempDir() + "sherd_" + test.test_suite_name() + "_" + test.name() + "_" + name;
}
