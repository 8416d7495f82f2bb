#include "suffuse/base/sha256.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <array>
#include <openssl/evp.h>

namespace suffuse {

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    expects(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1, "SHA-256 cannot be begun");
}

void Sha256::add(std::string_view bytes) {
    expects(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1, "SHA-256 refuses bytes");
}

std::string Sha256::hex() {
    std::array<unsigned char, 32> digest{};
    expects(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1, "SHA-256 cannot be ended");
    return fmt::format("{:02x}", fmt::join(digest, ""));
}

} // namespace suffuse
