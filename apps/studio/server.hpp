#pragma once
// The server of `suffuse studio`: binds a port of this machine, answers until it is stopped. It holds no state but its
// token: everything else is in the folder of the runs.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace suffuse::studio {

class Server {
public:
    /// @param folder of the runs; it exists
    /// @param page folder of the files that npm bundled
    /// @param examples that `suffuse new --from` knows
    Server(const std::filesystem::path& folder, const std::filesystem::path& page, std::vector<std::string> examples);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Takes a port of 127.0.0.1. @return false where another program has it
    bool bind(int port);

    /// The address to open: with the token.
    [[nodiscard]] std::string address() const;

    /// Answers, in a thread of its own.
    void start();
    void stop();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace suffuse::studio
