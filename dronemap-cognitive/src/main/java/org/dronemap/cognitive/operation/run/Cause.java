package org.dronemap.cognitive.operation.run;

import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Something that a plan has to be changed for; {@code words}: a sentence. */
public record Cause(Trigger trigger, @Nullable DroneId drone, String words) {}
