package org.dronemap.core.access;

import java.time.Instant;

/** A key for programs; the secret only as a SHA-256 hash (hexadecimal), since it is 256 random bits. */
public record AccessKey(String id, String label, String owner, Role role, String secretHash, Instant createdAt) {}
