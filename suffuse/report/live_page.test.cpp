#include "suffuse/report/live_page.hpp"

#include <gtest/gtest.h>

namespace suffuse::report {
namespace {

LivePage under_way() {
    LivePage page;
    page.title = "Dyke </title><script>alert(1)</script>";
    page.run = "dyke-0001";
    page.at = "12:00:00 UTC";
    page.share = 0.3;
    page.progress = "3 of 10 stages";
    page.left = "4-5 min";
    page.command = "suffuse resume runs/dyke-0001";
    page.rows = {
        {"erosion/initial", "compact", "done", "12 s", "e 0.686  unbalance 1.4e-05"},
        {"erosion/probe", "detach", "running", "3 s", ""}};
    return page;
}

TEST(LivePage, LoadsItselfAnewWhileTheRunIsUnderWayAndNeedsNeitherScriptNorServer) {
    const std::string text = render_live_page(under_way());
    EXPECT_NE(text.find("<meta http-equiv=\"refresh\" content=\"3\">"), std::string::npos);
    EXPECT_EQ(text.find("<script"), std::string::npos);
    EXPECT_EQ(text.find("http:"), std::string::npos);
    EXPECT_EQ(text.find("https:"), std::string::npos);
    EXPECT_NE(text.find("3 of 10 stages, 4-5 min left"), std::string::npos);
    EXPECT_NE(text.find("e 0.686  unbalance 1.4\u00a0×\u00a010⁻⁵"), std::string::npos);
    EXPECT_NE(
        text.find("the run was killed; continue it with <code>suffuse resume runs/dyke-0001</code>"), std::string::npos
    );
}

TEST(LivePage, StopsLoadingItselfWhenNothingMoreComes) {
    LivePage page = under_way();
    page.ending = "The run was stopped.";
    const std::string text = render_live_page(page);
    EXPECT_EQ(text.find("http-equiv=\"refresh\""), std::string::npos);
    EXPECT_EQ(text.find("min left"), std::string::npos);
    EXPECT_NE(text.find("<code>suffuse resume runs/dyke-0001</code>"), std::string::npos);
}

} // namespace
} // namespace suffuse::report
