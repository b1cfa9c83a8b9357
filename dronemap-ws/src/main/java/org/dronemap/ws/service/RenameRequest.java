package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import org.jspecify.annotations.Nullable;

/** A drone's new name. */
@Schema(name = "RenameRequest")
public record RenameRequest(@Nullable String name) {}
