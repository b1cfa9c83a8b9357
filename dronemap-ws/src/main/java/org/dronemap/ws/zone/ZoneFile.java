package org.dronemap.ws.zone;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Findings of a reader of zone files: zones to be, and what of the file is none, with the reason. One thread. */
final class ZoneFile {
    private final List<Part> parts = new ArrayList<>();
    private final List<LeftOut> leftOut = new ArrayList<>();

    /** One zone to be, and where in the document it stands. */
    record Part(String at, ZoneFeature feature) {}

    /** A piece of the file that becomes no zone, or not all of which does. */
    record LeftOut(String at, @Nullable String name, InvalidInput why) {}

    void add(String at, ZoneFeature feature) {
        parts.add(new Part(at, feature));
    }

    void leaveOut(String at, @Nullable String name, InvalidInput why) {
        leftOut.add(new LeftOut(at, name, why));
    }

    /** One that turned out to be none after all. */
    void leaveOut(Part part, InvalidInput why) {
        ZoneFeature.ZoneProperties properties = part.feature().properties();
        String at = part.at().isEmpty()
                ? "feature"
                : part.at().substring(0, part.at().length() - 1);
        leaveOut(at, properties == null ? null : properties.name(), why);
    }

    /** A kind of piece that is no area. */
    void leaveOut(String at, @Nullable String name, String kind) {
        leaveOut(
                at,
                name,
                new InvalidInput(
                        ValueProblem.FILE_UNUSABLE, at, "an area", "A " + kind + " is no area and cannot be a zone."));
    }

    /** Heights of corners say nothing about where a zone begins and ends. */
    void leaveOutHeights(String at, String name, double least, double most) {
        leaveOut(
                at,
                name,
                new InvalidInput(
                        ValueProblem.AREA_UNUSABLE,
                        at,
                        "longitude and latitude",
                        "The heights of its corners (" + least + " to " + most
                                + " m) are not taken; without a floor and a ceiling of its own the zone holds at all"
                                + " heights."));
    }

    List<Part> parts() {
        return parts;
    }

    List<LeftOut> leftOut() {
        return leftOut;
    }

    /** Why there is not a single zone in it: the reason itself where there is only one. */
    InvalidInput nothing() {
        if (leftOut.size() == 1) {
            return leftOut.get(0).why();
        }
        return leftOut.isEmpty()
                ? new InvalidInput(
                        ValueProblem.FILE_UNUSABLE, "file", "at least one area", "There is no area in this file.")
                : new InvalidInput(
                        ValueProblem.FILE_UNUSABLE,
                        "file",
                        "at least one area",
                        "None of the " + leftOut.size() + " pieces of this file can be a zone. The first: "
                                + leftOut.get(0).why().sentence());
    }
}
