package org.dronemap.ws.service;

import org.dronemap.core.access.User;

/** A user as administrators see it. */
public record UserView(String name, String role, String state, boolean mustChangePassword) {
    static UserView of(User user) {
        return new UserView(
                user.name(), WireNames.camel(user.role()), WireNames.camel(user.state()), user.mustChangePassword());
    }
}
