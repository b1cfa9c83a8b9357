package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;

/** A user as administrators see it; {@code onlyGranted}: sees no drone by the role alone. */
@Schema(name = "UserView")
record UserView(
        String name,
        @EnumValues(Role.class) String role,
        @EnumValues(AccountState.class) String state,
        boolean mustChangePassword,
        boolean onlyGranted) {
    static UserView of(User user, boolean onlyGranted) {
        return new UserView(
                user.name(),
                WireNames.camel(user.role()),
                WireNames.camel(user.state()),
                user.mustChangePassword(),
                onlyGranted);
    }
}
