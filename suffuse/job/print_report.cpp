#include "suffuse/job/print_report.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/leftovers.hpp"
#include "suffuse/job/other_program.hpp"
#include "suffuse/job/scratch_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <unistd.h>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

std::string find_browser(const fs::path& page) {
    constexpr std::array<const char*, 3> browsers = {"chromium", "chromium-browser", "google-chrome"};
    for (const char* const each : browsers) {
        if (is_installed(each)) {
            return each;
        }
    }
    throw IoError(fmt::format(
        "no browser to print with: install Chromium (Debian: chromium), or open {} in any browser and print it to a "
        "file",
        shell_word(page.string())
    ));
}

std::string reason_of(const ProgramEnd& end) {
    return !end.complaint.empty() ? end.complaint
           : end.code > 128       ? fmt::format("signal {} ended it", end.code - 128)
           : end.code > 0         ? fmt::format("it ended with code {} and no message", end.code)
                                  : "it reported success but wrote nothing";
}

} // namespace

void print_report(const fs::path& page, const fs::path& pdf, const std::string& browser) {
    const fs::path target = fs::absolute(pdf);
    const ScratchFolder profile(target.parent_path()); // so that a running browser is not used for it
    const fs::path whole = fs::absolute(page).lexically_normal();
    if (!fs::exists(whole)) {
        throw IoError(fmt::format("{}: is not there to be printed", whole.string()));
    }
    io::remove_leftovers(target.parent_path(), [&](std::string_view name) { return target.filename() == name; });
    const fs::path printed = io::next_partial(target); // what was there before stays until this is whole
    std::vector<std::string> words = {
        browser.empty() ? find_browser(page) : browser,
        "--headless",
        "--disable-gpu",
        "--no-first-run",
        "--user-data-dir=" + profile.path().string(),
        "--no-pdf-header-footer",
        "--virtual-time-budget=120000", // until the page's own script has drawn; ends early where nothing waits
        "--print-to-pdf=" + printed.string(),
        "--generate-pdf-document-outline",
    };
    if (geteuid() == 0) { // Chromium's sandbox refuses root, as in a container; the page is our own and loads nothing
        words.emplace_back("--no-sandbox");
    }
    std::string address = "file://";
    for (const char letter : whole.string()) {
        const bool is_plain = (std::isalnum(static_cast<unsigned char>(letter)) != 0) || letter == '/' ||
                              letter == '-' || letter == '_' || letter == '.' || letter == '~';
        address += is_plain ? std::string(1, letter) : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    }
    words.push_back(address);
    std::error_code error;
    const ProgramEnd end = run_program(words);
    if (end.code != 0 || !fs::exists(printed)) {
        fs::remove(printed, error);
        throw IoError(fmt::format(
            "{} could not print {}: {}; {}", words.front(), page.string(), reason_of(end),
            fs::exists(pdf) ? "the existing PDF was left unchanged" : "no PDF was made"
        ));
    }
    fs::rename(printed, target, error);
    if (error) {
        fs::remove(printed, error);
        throw IoError(fmt::format("cannot write {}: choose a folder that you may write to", pdf.string()));
    }
}

} // namespace suffuse::job
