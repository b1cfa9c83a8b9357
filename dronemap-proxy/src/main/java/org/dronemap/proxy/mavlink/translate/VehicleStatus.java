package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;

/**
 * The last reported status of one MAVLink vehicle (mode, armed, position, home, mission), for its commands. Owned by
 * the drone's lane.
 */
public final class VehicleStatus {
    private static final int ARMED_FLAG = 128;
    private static final int CAPABILITY_MISSION_INT = 4;
    private static final int MISSION_COMPLETE = 5;
    private static final Set<String> MISSION_MODES = Set.of("AUTO", "MISSION");
    private static final double CLEARLY_ABOVE_METERS = 1;

    private int type;
    private @Nullable Heartbeat heartbeat;
    private @Nullable AutopilotVersion version;
    private @Nullable String mode;
    private @Nullable FlightPhase phase;
    private @Nullable Geodetic point;
    private @Nullable Double altitudeAmslMeters;
    private @Nullable Double altitudeAboveHomeMeters;
    private @Nullable Double homeAltitudeAmslMeters;
    private int homeLatitudeE7;
    private int homeLongitudeE7;
    private boolean lostItsPlace;
    private int currentSeq = -1;
    private int lastSeqReached = -1;
    private @Nullable List<MissionItemInt> mission;
    private boolean missionComplete;
    private boolean missionReplaced;
    private int pictures;
    private @Nullable Double speed;

    /**
     * @param type the MAV_TYPE, which makes the session
     * @param pictures where their numbers begin: anywhere, so that a camera never takes a new picture for the repetition of
     *     an old one
     */
    public VehicleStatus(int type, int pictures) {
        this.type = type;
        this.pictures = pictures;
    }

    public int type() {
        return type;
    }

    /** The vehicle has turned out to be of another type than its heartbeats say. */
    public void type(int found) {
        type = found;
    }

    public boolean armed() {
        Heartbeat last = heartbeat;
        return last != null && (last.baseMode() & ARMED_FLAG) != 0;
    }

    /** Numbers pictures, so that a camera knows a repeated order. */
    int nextPicture() {
        return ++pictures;
    }

    /** Its name; null before it was told. */
    @Nullable
    String mode() {
        return mode;
    }

    public boolean inMode(String name) {
        return name.equals(mode);
    }

    public @Nullable AutopilotVersion version() {
        return version;
    }

    /** By its own word; false also as long as it has said nothing of it. */
    public boolean knowsIntegerItems() {
        AutopilotVersion heard = version;
        return heard != null && (heard.capabilities() & CAPABILITY_MISSION_INT) != 0;
    }

    public @Nullable Heartbeat heartbeat() {
        return heartbeat;
    }

    public @Nullable FlightPhase phase() {
        return phase;
    }

    public @Nullable Double altitudeAboveHomeMeters() {
        return altitudeAboveHomeMeters;
    }

    /** In the air as far as it says. */
    public boolean airborne() {
        Double above = altitudeAboveHomeMeters;
        FlightPhase last = phase;
        return armed()
                && !VehicleType.kind(type).neverFlies()
                && (last != null ? last != FlightPhase.ON_GROUND : above != null && above > CLEARLY_ABOVE_METERS);
    }

    /** Home's altitude as told, else as position and height above home imply; null when neither was heard. */
    public @Nullable Double homeAltitudeAmslMeters() {
        if (homeAltitudeAmslMeters != null) {
            return homeAltitudeAmslMeters;
        }
        return altitudeAmslMeters != null && altitudeAboveHomeMeters != null
                ? Double.valueOf(altitudeAmslMeters - altitudeAboveHomeMeters)
                : null;
    }

    /** Its estimator says that it does not know where it is. */
    boolean hasLostItsPlace() {
        return lostItsPlace;
    }

    void placeKnown(boolean known) {
        lostItsPlace = !known;
    }

    /** Degrees × 1e7; 0 as long as home was not told. */
    public int homeLatitudeE7() {
        return homeLatitudeE7;
    }

    /** Degrees × 1e7; 0 as long as home was not told. */
    public int homeLongitudeE7() {
        return homeLongitudeE7;
    }

    /** It has reached its last mission item, or says that it is through, so that starting means starting over. */
    private boolean missionFinished() {
        List<MissionItemInt> items = mission;
        return missionComplete || (items != null && !items.isEmpty() && lastSeqReached >= items.size() - 1);
    }

    /**
     * It is in the middle of the mission that it has, so that starting means going on: known by the item that it is at, not by
     * its height. What flies and is on the ground again has to begin with its take-off.
     *
     * @param first the number on the wire of the mission's first item
     */
    boolean resumesMission(int first) {
        boolean canGoOn = VehicleType.kind(type).neverFlies() || airborne();
        boolean begun = currentSeq > first || lastSeqReached >= first;
        return canGoOn && begun && !missionReplaced && !missionFinished();
    }

    /** It has got another mission than the one that it was in, or the same one anew. */
    public void missionReplaced() {
        missionReplaced = true;
        missionComplete = false;
        lastSeqReached = -1;
    }

    /** It goes by its mission now. */
    private void missionFlown() {
        missionReplaced = false;
    }

    /** True only when it was read and found empty. */
    boolean hasNoMission() {
        List<MissionItemInt> items = mission;
        return items != null && items.isEmpty();
    }

    public int currentSeq() {
        return currentSeq;
    }

    /** Vehicles forget a speed that they were told with the mode that they were in. */
    void heartbeat(Heartbeat last, String modeName) {
        if (!modeName.equals(mode)) {
            speed = null;
        }
        if (armed() && MISSION_MODES.contains(modeName)) {
            missionFlown();
        }
        heartbeat = last;
        mode = modeName;
    }

    public void version(AutopilotVersion heard) {
        version = heard;
    }

    void phase(@Nullable FlightPhase heard) {
        phase = heard;
    }

    void speedChanged(double metersPerSecond) {
        speed = metersPerSecond;
    }

    /** What it was told since it is in this mode, in m/s; null: nothing. */
    @Nullable
    Double speed() {
        return speed;
    }

    void position(Position heard) {
        point = heard.point();
        altitudeAmslMeters = heard.altitudeAmslMeters();
        altitudeAboveHomeMeters = heard.altitudeAboveHomeMeters();
    }

    /** Where it says that it is; null: not told. */
    @Nullable
    Geodetic point() {
        return point;
    }

    void home(int latitudeE7, int longitudeE7, double altitudeMeters) {
        homeLatitudeE7 = latitudeE7;
        homeLongitudeE7 = longitudeE7;
        homeAltitudeAmslMeters = altitudeMeters;
    }

    /** It says that it has none. */
    void homeUnknown() {
        homeLatitudeE7 = 0;
        homeLongitudeE7 = 0;
        homeAltitudeAmslMeters = null;
    }

    /** {@code missionState} as MISSION_CURRENT says it; 0: not at all. */
    void current(int seq, int missionState) {
        missionComplete = missionState == MISSION_COMPLETE;
        if (seq < currentSeq) {
            lastSeqReached = -1;
        }
        currentSeq = seq;
    }

    void reached(int seq) {
        lastSeqReached = seq;
    }

    /** Its mission as last read, as on the wire, home included; null before. */
    public @Nullable List<MissionItemInt> mission() {
        return mission;
    }

    /** The mission was read: items as on the wire, home included. */
    public void missionRead(List<MissionItemInt> wireItems) {
        List<MissionItemInt> before = mission;
        if (before == null || wireItems.size() != before.size()) {
            lastSeqReached = -1;
        }
        mission = List.copyOf(wireItems);
    }
}
