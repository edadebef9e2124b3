// sheets.pdf: printed by a browser that is installed.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "report/sheets/sheets_page.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/scratch_folder.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

/// A browser that has not printed a few sheets by then never will [s].
constexpr double kPatienceS = 60;
constexpr auto kLook = std::chrono::milliseconds(20);

/// A program of that name on the PATH; empty for none.
std::string onPath(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::string folders = path == nullptr ? "" : path;
    for (std::size_t from = 0; from < folders.size();) {
        const std::size_t end = std::min(folders.find(':', from), folders.size());
        const fs::path file = fs::path(folders.substr(from, end - from)) / name;
        std::error_code none;
        if (fs::is_regular_file(file, none) && ::access(file.c_str(), X_OK) == 0) return file.string();
        from = end + 1;
    }
    return {};
}

/// The command that prints page.html of a folder to page.pdf; empty where nothing can.
std::vector<std::string> printCommand(const fs::path& folder) {
    const std::string page = (folder / "page.html").string();
    const std::string pdf = (folder / "page.pdf").string();
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
        const std::string browser = onPath(name);
        if (browser.empty()) continue;
        std::vector<std::string> command{browser,
                                         "--headless",
                                         "--disable-gpu",
                                         "--disable-extensions",
                                         "--disable-background-networking",
                                         "--no-first-run",
                                         "--no-pdf-header-footer",
                                         "--user-data-dir=" + (folder / "profile").string(),
                                         "--print-to-pdf=" + pdf};
        // Chromium's sandbox refuses to run as root; the page runs no script and loads nothing.
        if (geteuid() == 0) command.emplace_back("--no-sandbox");
        command.push_back("file://" + page);
        return command;
    }
    return {};
}

/// Runs a command without a shell, silently. Is it done in time?
bool runsWell(const std::vector<std::string>& command) {
    std::vector<char*> words;
    words.reserve(command.size() + 1);
    for (const std::string& word : command)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_RDWR, 0);
    pid_t child = 0;
    const bool begun = posix_spawn(&child, words.front(), &streams, nullptr, words.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&streams);
    if (!begun) return false;
    const auto start = std::chrono::steady_clock::now();
    int status = 0;
    for (pid_t ended = 0; ended != child; ended = waitpid(child, &status, WNOHANG)) {
        if (ended < 0) return false;
        if (std::chrono::steady_clock::now() - start > std::chrono::duration<double>(kPatienceS)) {
            ::kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return false;
        }
        std::this_thread::sleep_for(kLook);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The digits of "/CreationDate (D:2026...)" and "/ModDate (...)" as zeros: places in the file stay.
void takeOutDates(std::string& pdf) {
    for (const std::string_view key : {"/CreationDate", "/ModDate"})
        for (std::size_t at = pdf.find(key); at != std::string::npos; at = pdf.find(key, at + 1)) {
            const std::size_t end = pdf.find(')', at);
            for (std::size_t i = at; i < std::min(end, pdf.size()); ++i)
                if (pdf[i] >= '0' && pdf[i] <= '9') pdf[i] = '0';
        }
}

std::string printIn(const fs::path& folder, const std::vector<std::string>& command, std::string_view html) {
    writeFile(folder / "page.html", html);
    if (!runsWell(command) || !fs::exists(folder / "page.pdf")) return {};
    std::string pdf = readFile(folder / "page.pdf");
    takeOutDates(pdf);
    return pdf;
}

}  // namespace

Sheets printed(std::string html) {
    Sheets sheets{std::move(html), "", ""};
    try {
        const ScratchFolder folder("sheets");
        const std::vector<std::string> command = printCommand(folder.path());
        if (command.empty()) {
            sheets.why_no_pdf = "Chromium is not installed";
            return sheets;
        }
        sheets.pdf = printIn(folder.path(), command, sheets.html);
        if (sheets.pdf.empty()) sheets.why_no_pdf = command.front() + " did not print it";
    } catch (const Error& error) {
        sheets.why_no_pdf = error.what();
    }
    return sheets;
}

Sheets makeSheets(const ProvenPlan& proven, const SheetOptions& options, bool with_pdf,
                  const Tolerances& tol) {
    using namespace report;
    Element main = sheetsOf(proven, options, tol);
    const std::string& name = proven.plan.part.name;
    Sheets sheets{sheetsPage(name, main, Paper::AsPrinter), "", ""};
    if (!with_pdf) return sheets;
    Sheets paper = printed(sheetsPage(name, std::move(main), options.inch ? Paper::Letter : Paper::A4));
    sheets.pdf = std::move(paper.pdf);
    sheets.why_no_pdf = std::move(paper.why_no_pdf);
    return sheets;
}

}  // namespace stepmill
