package org.dronemap.ws.server;

import org.jspecify.annotations.Nullable;

/** The version of this build. */
final class Version {
    private Version() {}

    static String current() {
        @Nullable String packaged = Version.class.getPackage().getImplementationVersion();
        return packaged == null ? "development" : packaged;
    }
}
