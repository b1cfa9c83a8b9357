package org.dronemap.core.organisation;

/** Names an organisation; letters a to z, digits and hyphens, at most 40. */
public record OrganisationId(String value) {
    private static final int LONGEST = 40;

    /** The one that is always there, and whose administrators are the server's. */
    public static final OrganisationId HOME = new OrganisationId("home");

    public OrganisationId {
        if (value.length() > LONGEST || !value.matches("[a-z0-9-]+")) {
            throw new IllegalArgumentException("not the id of an organisation: " + value);
        }
    }

    public boolean isHome() {
        return equals(HOME);
    }

    @Override
    public String toString() {
        return value;
    }
}
