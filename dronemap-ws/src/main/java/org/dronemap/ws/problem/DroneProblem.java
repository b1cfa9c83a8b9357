package org.dronemap.ws.problem;

/** Problem codes of requests that the state of a drone, its endpoint, its logs or its recordings does not allow. */
public enum DroneProblem implements ProblemCode {
    COMMAND_ID_TAKEN(ProblemCatalogueEntry.of(
                    "command-id-taken",
                    RejectionKind.CONFLICT,
                    "Another command has this id.",
                    "The id c-12345678 belongs to another command already; take a new one.")
            .with(ProblemParameter.COMMAND)),
    DRONE_IN_CONTACT(ProblemCatalogueEntry.of(
                    "drone-in-contact",
                    RejectionKind.CONFLICT,
                    "Only a drone that is lost can be removed.",
                    "The drone is in contact; it would come back at once.")
            .with(ProblemParameter.DRONE)),
    DRONE_NOT_AT_REST(ProblemCatalogueEntry.of(
                    "drone-not-at-rest",
                    RejectionKind.CONFLICT,
                    "The drone is armed or in the air.",
                    "It is armed or in the air; land and disarm it first.")
            .with(ProblemParameter.DRONE)),
    DRONE_IN_OPERATION(ProblemCatalogueEntry.of(
                    "drone-in-operation",
                    RejectionKind.CONFLICT,
                    "An operation has control of the drone.",
                    "An operation has control of it; end that first.")
            .with(ProblemParameter.DRONE)),
    DRONE_IN_WAREHOUSE(ProblemCatalogueEntry.of(
                    "drone-in-warehouse",
                    RejectionKind.CONFLICT,
                    "The drone may be chosen for virtual drones at any moment.",
                    "It may serve virtual drones; take it out of the warehouse first.")
            .with(ProblemParameter.DRONE)),
    POSITION_UNKNOWN(ProblemCatalogueEntry.of(
                    "position-unknown",
                    RejectionKind.CONFLICT,
                    "Where the drone is, or how high, is not known.",
                    "Where “Kestrel” is, is not known.")
            .with(ProblemParameter.DRONE)),
    ALTITUDE_IMPLAUSIBLE(ProblemCatalogueEntry.of(
                    "altitude-implausible",
                    RejectionKind.CONFLICT,
                    "The drone tells an altitude that cannot be.",
                    "The altitude that “Kestrel” tells (40000 m) cannot be.")
            .with(ProblemParameter.DRONE, ProblemParameter.ALTITUDE)),
    BATTERY_UNKNOWN(ProblemCatalogueEntry.of(
                    "battery-unknown",
                    RejectionKind.CONFLICT,
                    "How full the drone's battery is, is not known.",
                    "How full the battery of “Kestrel” is, is not known.")
            .with(ProblemParameter.DRONE)),
    LINK_QUALITY_UNKNOWN(ProblemCatalogueEntry.of(
                    "link-quality-unknown",
                    RejectionKind.CONFLICT,
                    "How good the drone's link is, is not known yet.",
                    "How good the link of “Kestrel” is, is not known yet; that takes some seconds of contact.")
            .with(ProblemParameter.DRONE)),
    LINK_FALLING(ProblemCatalogueEntry.of(
                    "link-falling",
                    RejectionKind.CONFLICT,
                    "The drone's link gets worse so quickly that it is expected to be lost soon.",
                    "“Kestrel” cannot be planned with. Its link gets worse (34 % of its messages are lost, usually 2 %):"
                            + " it is expected to be lost in about 40 s.")
            .with(ProblemParameter.DRONE)),
    CONTACT_NOT_GOOD(ProblemCatalogueEntry.of(
                    "contact-not-good",
                    RejectionKind.CONFLICT,
                    "There is no good contact with the drone.",
                    "There is no good contact with “Kestrel”.")
            .with(ProblemParameter.DRONE)),
    VEHICLE_UNKNOWN(ProblemCatalogueEntry.of(
                    "vehicle-unknown",
                    RejectionKind.CONFLICT,
                    "What kind of vehicle the drone is, or what it can do, is not known.",
                    "What kind of vehicle “Kestrel” is, and what it can do, is not known.")
            .with(ProblemParameter.DRONE)),
    PARAMETERS_NOT_READ(ProblemCatalogueEntry.of(
                    "parameters-not-read",
                    RejectionKind.CONFLICT,
                    "The vehicle's parameters have not been read yet.",
                    "The parameters of this drone have not been read yet; refresh them first.")
            .with(ProblemParameter.DRONE)),
    LOGS_NOT_LISTED(ProblemCatalogueEntry.of(
                    "logs-not-listed",
                    RejectionKind.CONFLICT,
                    "The vehicle's logs have not been listed yet.",
                    "The logs of this drone have not been listed yet; refresh them first.")
            .with(ProblemParameter.DRONE)),
    LOG_NOT_FETCHED(ProblemCatalogueEntry.of(
                    "log-not-fetched",
                    RejectionKind.CONFLICT,
                    "The server has no copy of this log.",
                    "This log has not been fetched from the vehicle yet.")
            .with(ProblemParameter.DRONE)),
    LOG_FETCHED(ProblemCatalogueEntry.of(
                    "log-fetched",
                    RejectionKind.CONFLICT,
                    "The server has a copy of this log already.",
                    "The server has this log already; save the file, or remove it to fetch it anew.")
            .with(ProblemParameter.DRONE)),
    NO_ZONE_FOR_FENCE(ProblemCatalogueEntry.of(
                    "no-zone-for-fence",
                    RejectionKind.CONFLICT,
                    "No zone that a vehicle can keep binds the drone.",
                    "No zone without floor and ceiling binds this drone now; its fence stays as it is.")
            .with(ProblemParameter.DRONE)),
    FENCE_FULL(ProblemCatalogueEntry.of(
                    "fence-full",
                    RejectionKind.CONFLICT,
                    "More zones bind the drone than a vehicle keeps.",
                    "30 zones bind this drone now; a vehicle keeps 20 at most. Its fence stays as it is.")
            .with(ProblemParameter.DRONE, ProblemParameter.COUNT, ProblemParameter.MOST)),
    ENDPOINT_KNOWN(ProblemCatalogueEntry.of(
            "endpoint-known",
            RejectionKind.CONFLICT,
            "The server has this endpoint already.",
            "There is an endpoint udpin:0.0.0.0:14551 already.")),
    ENDPOINT_OF_SETTING(ProblemCatalogueEntry.of(
            "endpoint-of-setting",
            RejectionKind.CONFLICT,
            "The endpoint is set where the server is configured.",
            "udpin:0.0.0.0:14550 is set by DRONEMAP_ENDPOINTS or DRONEMAP_ROBOTS; change the setting.")),
    OF_ANOTHER_ORGANISATION(ProblemCatalogueEntry.of(
            "of-another-organisation",
            RejectionKind.CONFLICT,
            "It is from a time when the drone was another organisation's.",
            "The drone was another organisation's then; only that one writes notes.")),
    NO_RECORDING_THEN(ProblemCatalogueEntry.of(
                    "no-recording-then",
                    RejectionKind.CONFLICT,
                    "Nothing was recorded of the drone at that time.",
                    "There is no recording of that drone at that time, so there is no tlog; the other forms are made of what was kept of its state.")
            .with(ProblemParameter.DRONE)),
    RECORDING_NOT_PLAYABLE(ProblemCatalogueEntry.of(
                    "recording-not-playable",
                    RejectionKind.CONFLICT,
                    "The recording holds texts, which no map shows.",
                    "This recording holds texts and cannot be played on the map; download it instead.")
            .with(ProblemParameter.ID)),
    RECORDING_FILE_GONE(ProblemCatalogueEntry.of(
                    "recording-file-gone",
                    RejectionKind.CONFLICT,
                    "The file of the recording is no longer there.",
                    "The file of recording r1 is not there any more.")
            .with(ProblemParameter.ID)),
    RECORDING_GOES_ON(ProblemCatalogueEntry.of(
                    "recording-goes-on",
                    RejectionKind.CONFLICT,
                    "The recording is being written.",
                    "This recording goes on; it can be deleted when it has ended.")
            .with(ProblemParameter.ID)),
    SENDERS_NOT_RECORDED(ProblemCatalogueEntry.of(
                    "senders-not-recorded",
                    RejectionKind.CONFLICT,
                    "The recording does not tell who sent what.",
                    "Recording r1 was made before it was noted who sent what.")
            .with(ProblemParameter.ID)),
    NOTHING_RECORDED(ProblemCatalogueEntry.of(
            "nothing-recorded",
            RejectionKind.CONFLICT,
            "The record of calls is empty.",
            "Nothing has been recorded yet; there is nothing to give a receipt for."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    DroneProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
