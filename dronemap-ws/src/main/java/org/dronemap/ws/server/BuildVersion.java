package org.dronemap.ws.server;

import org.jspecify.annotations.Nullable;

/** The version of this server build. */
public final class BuildVersion {
    private BuildVersion() {}

    public static String current() {
        @Nullable String packaged = BuildVersion.class.getPackage().getImplementationVersion();
        return packaged == null ? "development" : packaged;
    }
}
