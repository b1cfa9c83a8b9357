package org.dronemap.ws.settings;

import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.jspecify.annotations.Nullable;

/** Reads the OpenID Connect settings from the environment. */
final class OidcSettingsReader {
    private static final String ISSUER = "DRONEMAP_OIDC_ISSUER";
    private static final String ADDRESS = "DRONEMAP_OIDC_ADDRESS";
    private static final String CLIENT = "DRONEMAP_OIDC_CLIENT_ID";
    private static final String SECRET = "DRONEMAP_OIDC_CLIENT_SECRET";
    private static final String LABEL = "DRONEMAP_OIDC_NAME";
    private static final String ACCOUNTS = "DRONEMAP_OIDC_ACCOUNTS";
    private static final String CLAIM = "DRONEMAP_OIDC_ROLE_CLAIM";
    private static final String ROLES = "DRONEMAP_OIDC_ROLES";
    private static final String CALLBACK = "/api/v1/session/oidc/callback";

    private OidcSettingsReader() {}

    /** Null when no provider is named. */
    static @Nullable OidcSettings of(Map<String, String> environment) {
        String issuer = text(environment, ISSUER);
        if (issuer == null) {
            return null;
        }
        URI provider = address(ISSUER, issuer);
        String own = needed(environment, ADDRESS).replaceFirst("/+$", "");
        String label = text(environment, LABEL);
        return new OidcSettings(
                provider,
                new OidcSettings.Client(needed(environment, CLIENT), text(environment, SECRET)),
                address(ADDRESS, own + CALLBACK),
                label == null ? provider.getHost() : label,
                accounts(environment),
                roles(environment));
    }

    private static @Nullable String text(Map<String, String> environment, String name) {
        String value = environment.getOrDefault(name, "").strip();
        return value.isEmpty() ? null : value;
    }

    private static String needed(Map<String, String> environment, String name) {
        String value = text(environment, name);
        if (value == null) {
            throw new SetupException(ISSUER + " is set, and " + name + " is missing.");
        }
        return value;
    }

    private static URI address(String name, String value) {
        try {
            URI address = URI.create(value);
            boolean encrypted = "https".equals(address.getScheme());
            if (address.getHost() != null && (encrypted || isHere(address))) {
                return address;
            }
        } catch (IllegalArgumentException notAnAddress) {
            // answered below
        }
        throw new SetupException(name + " must be an address such as https://login.example.org (http only on this"
                + " machine), not \"" + value + "\".");
    }

    private static boolean isHere(URI address) {
        try {
            return "http".equals(address.getScheme())
                    && InetAddress.getByName(address.getHost()).isLoopbackAddress();
        } catch (UnknownHostException e) {
            return false;
        }
    }

    private static AccountState accounts(Map<String, String> environment) {
        String value = text(environment, ACCOUNTS);
        return switch (value == null ? "waiting" : value) {
            case "waiting" -> AccountState.WAITING;
            case "active" -> AccountState.ACTIVE;
            default -> throw new SetupException(ACCOUNTS + " must be waiting or active, not \"" + value + "\".");
        };
    }

    private static OidcSettings.Roles roles(Map<String, String> environment) {
        String claim = text(environment, CLAIM);
        String list = text(environment, ROLES);
        if (claim == null && list == null) {
            return OidcSettings.Roles.OURS;
        }
        if (claim == null || list == null) {
            throw new SetupException(CLAIM + " and " + ROLES + " belong together; only one of them is set.");
        }
        Map<String, Role> roles = new HashMap<>();
        for (String pair : list.split(",", -1)) {
            int equals = pair.lastIndexOf('=');
            if (equals < 1) {
                throw wrongRoles(list);
            }
            try {
                roles.put(
                        pair.substring(0, equals).strip(),
                        Role.valueOf(pair.substring(equals + 1).strip().toUpperCase(Locale.ROOT)));
            } catch (IllegalArgumentException unknownRole) {
                throw wrongRoles(list);
            }
        }
        return new OidcSettings.Roles(claim, roles);
    }

    private static SetupException wrongRoles(String list) {
        return new SetupException(
                ROLES + " must be a list such as pilots=operator,office=viewer, with roles of Dronemap, not \"" + list
                        + "\".");
    }
}
