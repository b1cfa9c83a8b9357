package org.dronemap.ws.security.oidc;

import java.net.URI;
import java.util.Map;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/**
 * Settings of the OpenID Connect provider with which users may sign in.
 *
 * @param callback where the provider sends people back to
 * @param label what the button of the page names
 * @param newAccounts what becomes of somebody who comes for the first time
 */
public record OidcSettings(
        URI issuer, Client client, URI callback, String label, AccountState newAccounts, Roles roles) {

    /**
     * OAuth client registration of this server at the provider; without a secret a public client, protected by PKCE
     * alone.
     */
    public record Client(String id, @Nullable String secret) {
        @Override
        public String toString() {
            return id;
        }
    }

    /**
     * Mapping of a claim of the provider to roles.
     *
     * @param claim null: none, administrators give them here
     * @param byValue of the claim
     */
    public record Roles(@Nullable String claim, Map<String, Role> byValue) {
        /** Roles are given here. */
        public static final Roles OURS = new Roles(null, Map.of());

        public Roles {
            byValue = Map.copyOf(byValue);
        }
    }
}
