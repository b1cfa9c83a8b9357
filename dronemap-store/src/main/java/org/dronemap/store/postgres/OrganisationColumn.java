package org.dronemap.store.postgres;

import java.sql.SQLException;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/** Converts the organisation that a row belongs to to its column and back; null is the default organisation. */
final class OrganisationColumn {
    private static final String NAME = "organisation";

    private OrganisationColumn() {}

    static @Nullable String stored(OrganisationId organisation) {
        return organisation.isHome() ? null : organisation.value();
    }

    static OrganisationId read(ResultRow row) throws SQLException {
        String id = row.textOrNull(NAME);
        return id == null ? OrganisationId.HOME : new OrganisationId(id);
    }
}
