package org.dronemap.core.access;

/** A person; the password only as a salted hash. */
public record User(String name, Role role, String passwordHash, boolean mustChangePassword) {}
