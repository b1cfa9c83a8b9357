package org.dronemap.core.access;

import java.time.Instant;

/** A browser's session: SHA-256 of its cookie (hexadecimal), whose it is, when it ends. */
public record SignIn(String tokenHash, String user, Instant expiresAt) {}
