#pragma once
// A whole migration, for tests of its end.

#include "suffuse/erosion/migration.hpp"

namespace suffuse::test {

inline erosion::Migration
migrate(const dem::World& sample, const erosion::MigrateSpec& spec, const erosion::Surroundings& around = {}) {
    erosion::Migration migration = erosion::begin_migration(sample, spec, around);
    while (!migration.over) {
        erosion::migrate_on(migration, spec, around);
    }
    return migration;
}

} // namespace suffuse::test
