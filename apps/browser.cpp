#include "apps/browser.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace suffuse::apps {

bool open_in_browser(const std::string& page) {
    const std::string program = "xdg-open";
    char* const words[] = {const_cast<char*>(program.c_str()), const_cast<char*>(page.c_str()), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) != 0) {
        return false;
    }
    int status = 0;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace suffuse::apps
