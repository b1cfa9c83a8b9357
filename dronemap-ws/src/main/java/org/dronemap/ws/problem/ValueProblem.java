package org.dronemap.ws.problem;

/** Problem codes of wrong or missing values in requests; each names the field and what is allowed there. */
public enum ValueProblem implements ProblemCode {
    VALUE_MISSING(of("value-missing", "A value is missing.", "\"latitude\" is missing; it must be -90 to 90 degrees.")),
    VALUE_OUT_OF_RANGE(of(
                    "value-out-of-range",
                    "A number or a time is not within its range.",
                    "\"latitude\" must be -90 to 90 degrees, not 91.0.")
            .maybe(ProblemParameter.LEAST, ProblemParameter.MOST, ProblemParameter.UNIT)),
    VALUE_NOT_ALLOWED(of(
            "value-not-allowed",
            "A value is none of those that are allowed there.",
            "\"properties.onBreach\" must be hold, returnToLaunch or land, not \"wait\".")),
    VALUE_MALFORMED(of(
            "value-malformed",
            "A value is of another type, or written in another way, than its field wants.",
            "\"altitude\" must be a number.")),
    SIZE_OUT_OF_RANGE(of(
                    "size-out-of-range",
                    "A list has too few or too many entries, or a text too few or too many characters.",
                    "\"items\" must be 1 to 500 items, not 700.")
            .maybe(ProblemParameter.LEAST, ProblemParameter.MOST)),
    MEMBER_UNKNOWN(of(
            "member-unknown",
            "There is no member or element of this name here.",
            "There is no member \"altitde\" here; there are: latitude, longitude, altitude.")),
    REFERENCE_UNKNOWN(of(
            "reference-unknown",
            "A value names a drone, user or other thing that there is none of, or that the asker does not see.",
            "\"user\" must be the name of a user, not \"mia\".")),
    VALUES_EXCLUSIVE(of(
            "values-exclusive",
            "Of several values exactly one, or one at most, may be given.",
            "A zone binds a user or a drone, not both.")),
    VALUE_NOT_UNIQUE(of(
            "value-not-unique",
            "Two things of one request, or of what it belongs to, have the same id.",
            "Two waypoints are called \"w1\".")),
    CONFIRMATION_MISSING(of(
            "confirmation-missing",
            "What cannot be undone has to be confirmed.",
            "A deleted recording cannot be brought back; say confirm=true if that is meant.")),
    FILE_UNUSABLE(of(
            "file-unusable",
            "A file can be read, but there is nothing in it that can be used.",
            "There is no Polygon in this KML file.")),
    AREA_UNUSABLE(of(
            "area-unusable",
            "An area has holes, crosses itself, or is too small or too large.",
            "An area with holes cannot be guarded as one; draw it in parts without holes.")),
    PLACES_UNPLANNABLE(of(
            "places-unplannable",
            "Places are too far apart, or zones have too many corners, for a plan.",
            "This cannot be planned: the places are too far apart.")),
    MISSION_UNUSABLE(
            of(
                    "mission-unusable",
                    "The items of a mission are each right, but not as a whole, for what flies it.",
                    "The first waypoint's altitude is above sea level and the drone's home is not known yet, so no take-off height can be worked out; put a take-off item first.")),
    ALTITUDE_AMBIGUOUS(
            of(
                    "altitude-ambiguous",
                    "Homes of drones differ too much in height for altitudes above home.",
                    "The homes of these drones differ by 90 m in height, so above which home is meant is not known; give altitudes above sea level.")),
    EXPORT_TOO_LARGE(of(
            "export-too-large",
            "What is asked for has more points or bytes than one file may have.",
            "That is more than 500000 points; ask for a shorter time.")),
    TIME_NOT_SHOWN(of(
            "time-not-shown",
            "The time that is asked for is not shown to the asker, as the drone was another organisation's.",
            "The drone was another organisation's then.")),
    PRESENT_PASSWORD_WRONG(of(
            "present-password-wrong",
            "Who changes the password has not given the present one.",
            "The present password is not right.")),
    PASSWORD_UNCHANGED(of(
            "password-unchanged",
            "The new password is the old one.",
            "The new password must be another one than the present.")),
    INVITATION_NOT_VALID(of(
            "invitation-not-valid",
            "The code is of no invitation that is open.",
            "This invitation was used already, has expired or was withdrawn; ask for a new one.")),
    KEY_BOUNDS_TOO_WIDE(of(
            "key-bounds-too-wide",
            "The area or heights of a key go beyond those of the key that it is made with.",
            "\"ceiling\" of a key made with this one must be at most 50 m."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    ValueProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    private static ProblemCatalogueEntry of(String word, String meaning, String example) {
        return ProblemCatalogueEntry.of(word, RejectionKind.INVALID, meaning, example)
                .with(ProblemParameter.FIELD, ProblemParameter.ALLOWED);
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
