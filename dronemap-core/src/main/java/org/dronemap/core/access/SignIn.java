package org.dronemap.core.access;

import java.time.Instant;

/** A signed-in browser session: SHA-256 of its cookie (hexadecimal), its user and when it expires. */
public record SignIn(String tokenHash, String user, Instant expiresAt) {}
