// SPDX-License-Identifier: MIT
// The kinds of error that end a command, each with the exit code that main() returns for it. What happens to an animat
// is never an error but an Outcome.
#pragma once

#include <stdexcept>
#include <string>

namespace planula {

struct Error : std::runtime_error {
    Error(int exit_code, const std::string &message) : std::runtime_error(message), code(exit_code) {}
    int code;
};

/// A command line that cannot be understood.
struct UsageError : Error {
    explicit UsageError(const std::string &message) : Error(2, message) {}
};
/// A script or data file that breaks a rule.
struct InputError : Error {
    explicit InputError(const std::string &message) : Error(65, message) {}
};
/// An error in the program itself.
struct InternalError : Error {
    explicit InternalError(const std::string &message) : Error(70, message) {}
};
/// An output that cannot be created, or is in use.
struct CreateError : Error {
    explicit CreateError(const std::string &message) : Error(73, message) {}
};
/// A folder that another process works in, or that holds something else than the command would write: it is not
/// changed.
struct RefusedError : CreateError {
    using CreateError::CreateError;
};
/// A read or write that failed on the way.
struct IoError : Error {
    explicit IoError(const std::string &message) : Error(74, message) {}
};
/// The run was asked to stop; the same command resumes it.
struct Stopped : Error {
    explicit Stopped(const std::string &message) : Error(75, message) {}
};

} // namespace planula
