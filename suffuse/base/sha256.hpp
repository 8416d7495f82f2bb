#pragma once
// SHA-256 of bytes as they come: checksums that any machine's `sha256sum -c` can check without us.

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace suffuse {

class Sha256 {
public:
    Sha256();

    void add(std::string_view bytes);

    /// 64 hexadecimal digits of all that was added; nothing may be added afterwards.
    std::string hex();

private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

} // namespace suffuse
