package org.dronemap.ws.server;

import org.jspecify.annotations.Nullable;

/** The version of this build. */
final class BuildVersion {
    private BuildVersion() {}

    static String current() {
        @Nullable String packaged = BuildVersion.class.getPackage().getImplementationVersion();
        return packaged == null ? "development" : packaged;
    }
}
