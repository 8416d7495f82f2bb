#pragma once
// The report as a PDF, printed by a browser: its pages, numbers and title page are those of the page's style in print.

#include <filesystem>
#include <string>

namespace suffuse::job {

/// Prints `page` to `pdf`. @param browser its program; empty: chromium, chromium-browser or google-chrome, whichever is
/// installed
/// @throws IoError saying what to install, or that the browser could not print
void print_report(const std::filesystem::path& page, const std::filesystem::path& pdf, const std::string& browser = {});

} // namespace suffuse::job
