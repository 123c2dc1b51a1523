// SPDX-License-Identifier: MIT
#include "cli/failure.h"

#include <cstdio>
#include <new>
#include <string>
#include <system_error>

#include "cli/progress.h"
#include "cli/settings_options.h"
#include "dermis/error.h"

namespace dermis::cli {
namespace {

constexpr int failure = 1, usage_error = 2, software_error = 70;

int fail(std::string line, int status = failure) {
  show_line("");  // whatever was under way
  // Names of files may hold anything: a message stays one line.
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  std::fprintf(stderr, "dermis: %s\n", line.c_str());
  return status;
}

}  // namespace

int report_failure(const CLI::App& app) {
  try {
    throw;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_error;
  } catch (const InternalError& error) {
    return fail(error.what(), software_error);
  } catch (const std::bad_alloc&) {
    return fail("too little memory");
  } catch (const std::system_error& error) {
    // A thread that cannot be started says no more than "resource temporarily unavailable".
    return fail(error.code() == std::errc::resource_unavailable_try_again
                    ? "the system allows no more threads or memory"
                    : error.what());
  } catch (const std::exception& error) { return fail(with_options(error.what(), app)); }
}

}  // namespace dermis::cli
