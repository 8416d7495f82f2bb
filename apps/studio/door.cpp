#include "apps/studio/door.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <sys/random.h>

namespace suffuse::studio {
namespace {

std::string random_token() {
    std::array<unsigned char, 32> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        throw IoError("the system gives no random numbers for the studio's token");
    }
    std::string token;
    for (const unsigned char byte : bytes) {
        token += fmt::format("{:02x}", byte);
    }
    return token;
}

/// In a time that does not depend on where they differ.
bool are_equal(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) {
        return false;
    }
    unsigned difference = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        difference |= static_cast<unsigned>(static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]));
    }
    return difference == 0;
}

/// Why the body of a request is not read, as a status; 0: it is.
int refused_body(const httplib::Request& request) {
    if (request.method == "GET" || request.method == "HEAD" || request.method == "OPTIONS") {
        return 0;
    }
    if (request.has_header("Transfer-Encoding") || !request.has_header("Content-Length")) {
        return 411; // the library bounds what says its length
    }
    if (request.has_header("Content-Encoding")) {
        return 415; // a small body can unpack to a large one
    }
    const std::string text = request.get_header_value("Content-Length");
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    if (error != std::errc() || end != text.data() + text.size()) {
        return 400;
    }
    return length > most_upload ? 413 : 0;
}

/// For a browser that came from elsewhere, such as a link in a mail: its strict cookie goes along only with the next
/// request, which this page makes.
const char* const once_more =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>suffuse studio</title>"
    "<meta http-equiv=\"refresh\" content=\"0;url=/\"><p><a href=\"/\">suffuse studio</a></p>";

} // namespace

const char* const own_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; frame-src "
    "'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const char* const sandbox_policy =
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

httplib::Headers common_headers() {
    return {
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Cache-Control", "no-store"}};
}

Door::Door(int port)
    : host_(fmt::format("127.0.0.1:{}", port)), local_host_(fmt::format("localhost:{}", port)),
      cookie_(fmt::format("suffuse-studio-{}", port)), token_(random_token()) {}

std::string Door::address() const {
    return fmt::format("http://{}/?token={}", host_, token_);
}

bool Door::knows(const std::string& token) const {
    return are_equal(token, token_);
}

bool Door::has_cookie(const httplib::Request& request) const {
    const std::string text = request.get_header_value("Cookie"), name = cookie_ + "=";
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = std::min(text.find(';', begin), text.size());
        const std::string one = text.substr(begin, end - begin);
        if (one.starts_with(name) && knows(one.substr(name.size()))) {
            return true;
        }
        begin = text.find_first_not_of(' ', end + 1);
    }
    return false;
}

bool Door::answers(const httplib::Request& request, httplib::Response& response) const {
    const std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    if (request.get_header_value_count("Host") != 1 || (host != host_ && host != local_host_)) {
        refuse(response, 403, "this server answers only to the address that suffuse studio printed");
        return true;
    }
    if (request.has_header("Origin") && origin != "http://" + host_ && origin != "http://" + local_host_) {
        refuse(response, 403, "another page may not use this server");
        return true;
    }
    if (request.method == "GET" && request.path == "/" && request.has_param("token") &&
        knows(request.get_param_value("token"))) {
        response.set_redirect("/", 303);
        response.set_header("Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_, token_));
        return true;
    }
    if (!has_cookie(request)) {
        if (request.get_header_value("Sec-Fetch-Site") == "cross-site" && !request.has_param("token")) {
            response.status = 401;
            response.set_content(once_more, "text/html; charset=utf-8");
        } else {
            refuse(response, 401, "open the address that suffuse studio printed, with its token");
        }
        return true;
    }
    if (const int status = refused_body(request); status != 0) {
        refuse(
            response, status,
            status == 413 ? "more than 64 MB in one request" : "a request says its length and is not compressed"
        );
        return true;
    }
    return false;
}

} // namespace suffuse::studio
