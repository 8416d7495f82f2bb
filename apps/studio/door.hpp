#pragma once
// Who may enter: only this machine, only with the token, and never another page in the user's browser. STUDIO's page is
// served on 127.0.0.1, which every page in the browser and every user of the machine can reach.

#include "apps/studio/http.hpp"
#include <cstddef>
#include <string>

namespace suffuse::studio {

inline constexpr std::size_t most_upload = std::size_t{64} << 20; ///< of a request [B]

class Door {
public:
    /// Draws a token from the system's random numbers.
    explicit Door(int port);

    /// The address to open, once: with the token.
    [[nodiscard]] std::string address() const;

    /// Answers what may not enter, and the request that exchanges the token for a cookie.
    /// @return whether that was the answer
    [[nodiscard]] bool answers(const httplib::Request& request, httplib::Response& response) const;

private:
    [[nodiscard]] bool knows(const std::string& token) const;
    [[nodiscard]] bool has_cookie(const httplib::Request& request) const;

    std::string host_, local_host_; ///< as browsers name this server
    std::string cookie_;            ///< its name: cookies do not know ports, and two studios may run
    std::string token_;
};

/// Headers of every answer.
httplib::Headers common_headers();

/// The policy of the studio's own pages: nothing inline, nothing from elsewhere.
extern const char* const own_policy;

/// The policy of files of a run, which may come from others: without the rights of this server's pages.
extern const char* const sandbox_policy;

} // namespace suffuse::studio
