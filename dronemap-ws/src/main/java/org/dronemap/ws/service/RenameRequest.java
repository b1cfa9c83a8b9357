package org.dronemap.ws.service;

import org.jspecify.annotations.Nullable;

/** A drone's new name. */
public record RenameRequest(@Nullable String name) {}
