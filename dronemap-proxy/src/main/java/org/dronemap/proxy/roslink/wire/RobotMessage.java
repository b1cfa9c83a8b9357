package org.dronemap.proxy.roslink.wire;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A ROSLink message from a robot to the server; fields that are missing or invalid are null. A field that is missing,
 * is no number or is not finite is null: each bridge leaves out others. Metres, radians and seconds where nothing else
 * is said.
 */
public sealed interface RobotMessage {
    /** {@code type} says what machine it is. */
    record Heartbeat(
            @Nullable Integer type,
            @Nullable String name,
            @Nullable Integer systemStatus,
            @Nullable Integer mode) implements RobotMessage {}

    /** {@code state} means something else for each type of robot; the battery in the units of its bridge. */
    record Status(
            @Nullable Integer state,
            @Nullable Double batteryVoltage,
            @Nullable Double batteryCurrent,
            @Nullable Double batteryRemaining)
            implements RobotMessage {}

    /** The position, velocity and attitude of a robot in its own frame; {@code z} is a yaw on ground robots. */
    record Motion(Triple place, Triple speed, Triple turn, Angles angles) implements RobotMessage {}

    /** Three axes. */
    record Triple(
            @Nullable Double x,
            @Nullable Double y,
            @Nullable Double z) {}

    /** {@code heading} is called yaw by some. */
    record Angles(
            @Nullable Double pitch,
            @Nullable Double roll,
            @Nullable Double heading) {}

    /** Degrees, metres; {@code fix} as the bridge counts it. */
    record Satellites(
            @Nullable Integer fix,
            @Nullable Double latitude,
            @Nullable Double longitude,
            @Nullable Double altitude,
            @Nullable Integer visible)
            implements RobotMessage {}

    /** One sweep of a range finder; a range that is null was not measured. */
    record Scan(
            @Nullable Double angleMin,
            @Nullable Double angleIncrement,
            @Nullable Double rangeMin,
            @Nullable Double rangeMax,
            List<@Nullable Double> ranges)
            implements RobotMessage {}

    /** A JPEG or PNG in Base64, perhaps broken into lines; what its bridge says of its size is not to be trusted. */
    record Image(String base64, @Nullable View view) implements RobotMessage {}

    /** The position from which an image was taken, in degrees and metres. */
    record View(
            @Nullable Double latitude,
            @Nullable Double longitude,
            @Nullable Double altitude) {}

    /** A map in Base64, and where its corner lies. */
    record MapImage(
            String base64,
            @Nullable Double width,
            @Nullable Double height,
            @Nullable Double xOffset,
            @Nullable Double yOffset,
            @Nullable Double resolution)
            implements RobotMessage {}

    /** A message of a kind that is not known here. */
    record Unknown() implements RobotMessage {}
}
