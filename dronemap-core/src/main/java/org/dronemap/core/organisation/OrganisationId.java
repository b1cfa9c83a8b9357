package org.dronemap.core.organisation;

import java.util.regex.Pattern;

/** Unique id of an organisation: letters a to z, digits and hyphens, at most 40. */
public record OrganisationId(String value) {
    private static final int LONGEST = 40;
    private static final Pattern FORM = Pattern.compile("[a-z0-9-]+");

    /** The one that is always there, and whose administrators are the server's. */
    public static final OrganisationId HOME = new OrganisationId("home");

    public OrganisationId {
        if (value.length() > LONGEST || !FORM.matcher(value).matches()) {
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
