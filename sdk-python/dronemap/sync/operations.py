"""A call for each operation of REST that returns when it is answered.

Written from the description of REST by `python -m generator`.
"""

# ruff: noqa: E501

from typing import Literal

from dronemap.contract import models
from dronemap.contract.operations import Operations
from dronemap.sync.loop import LoopThread


class SyncOperations:
    """The operations of REST under their names; each raises a `Problem` when the server refuses it."""

    def __init__(self, loop: LoopThread, awaited: Operations) -> None:
        self._loop = loop
        self._awaited = awaited

    def accept_plan(
        self, id: str, body: models.PlanAcceptRequest | None = None, *, wait: float | None = None
    ) -> models.PlanView:
        """Accept a plan (planner; to start it operator). Uploads each drone's mission: one outcome for each drone.
        With start the drones are armed and started, each when the plan says, once all have their missions. 200
        when nothing is under way any more, else 202. 409 when the plan must not be flown, or a drone has moved.
        """
        return self._loop.run(self._awaited.accept_plan(id, body, wait=wait))

    def add_endpoint(self, body: models.EndpointRequest) -> models.EndpointView:
        """Add an endpoint (administrator). It stays over restarts. While it cannot open it is listed as failed, and
        tried again.
        """
        return self._loop.run(self._awaited.add_endpoint(body))

    def add_fleet(self, body: models.FleetRequest) -> models.FleetView:
        """Make a fleet of drones."""
        return self._loop.run(self._awaited.add_fleet(body))

    def add_grant(self, body: models.GrantRequest) -> models.GrantView:
        """Grant something. To a user or a group; of drones, a fleet or all; operations of view, plan, command and
        administer. It takes from what a role allows, and binds those who see only what they were granted.
        """
        return self._loop.run(self._awaited.add_grant(body))

    def add_group(self, body: models.GroupRequest) -> models.GroupView:
        """Make a group of users."""
        return self._loop.run(self._awaited.add_group(body))

    def add_invitation(self, body: models.NewInvitation) -> models.InvitationView:
        """Invite somebody. The code is in this answer and never shown again; it serves once. The page takes it as
        /#invitation=CODE.
        """
        return self._loop.run(self._awaited.add_invitation(body))

    def add_mission(self, body: models.MissionRequest) -> models.SavedMissionView:
        """Save a mission (operator)."""
        return self._loop.run(self._awaited.add_mission(body))

    def add_organisation(self, body: models.OrganisationNameRequest) -> models.OrganisationView:
        """Make an organisation. Its first administrator comes by an invitation into it (POST /invitations)."""
        return self._loop.run(self._awaited.add_organisation(body))

    def add_run_barrier(self, id: str, body: models.ZoneFeature) -> models.RunView:
        """Add a zone to a mission run (operator). A GeoJSON feature as of a zone of the cloud; binds all drones of
        the run at once, until it is over.
        """
        return self._loop.run(self._awaited.add_run_barrier(id, body))

    def add_run_waypoints(self, id: str, body: models.RunWaypointsRequest) -> models.RunView:
        """Add waypoints to a mission run (operator). Shared out among the drones that fly."""
        return self._loop.run(self._awaited.add_run_waypoints(id, body))

    def add_user(self, body: models.NewUser) -> models.UserView:
        """Add a user. The password serves for the first sign-in; the user then has to take another one."""
        return self._loop.run(self._awaited.add_user(body))

    def add_virtual_drone(self, body: models.VirtualDroneRequest) -> models.VirtualDroneView:
        """Make a virtual drone (planner). With what it needs, and its mission if it is known."""
        return self._loop.run(self._awaited.add_virtual_drone(body))

    def add_zone(self, body: models.ZoneFeature) -> models.ZoneFeature:
        """Add a zone (supervisor). A GeoJSON feature: a Polygon with one ring, or a Point with properties.radius."""
        return self._loop.run(self._awaited.add_zone(body))

    def annotate_flight(self, id: str, body: models.FlightNotes) -> models.FlightView:
        """Write notes about a flight (operator)."""
        return self._loop.run(self._awaited.annotate_flight(id, body))

    def answer_run(self, id: str, proposal: str, body: models.RunAnswerRequest) -> models.RunView:
        """Answer a proposal of a mission run (operator). By its number. 409 when another one waits by now, or none."""
        return self._loop.run(self._awaited.answer_run(id, proposal, body))

    def begin_recovery(self, body: models.RecoveryRequest) -> models.RecoveryView:
        """Bring drones home, or down, together (operator). All stop where they are. Then each that returns climbs or
        descends to a height of its own, which is set as its return height too, and flies home in its turn; pads
        near each other are used one after the other. Each that lands does so where it is, one after the other
        where they are near. The return heights are put back on the ground. 409 when they do not fit between the
        lowest height and the ceiling, with the number that does, or when two would come down on one spot.
        """
        return self._loop.run(self._awaited.begin_recovery(body))

    def broadcast_command(self, body: models.BroadcastRequest, *, wait: float | None = None) -> models.BroadcastView:
        """Give one command to several drones or all (operator). One result for each drone, in the order asked: its
        command, refused, under way or ended. 200 when none is under way any more, else 202.
        """
        return self._loop.run(self._awaited.broadcast_command(body, wait=wait))

    def cancel_dispatch(self, id: str) -> models.DispatchView:
        """Call a drone off that was sent (operator). It flies home, also when it is there and you have control of
        it. 409 when it was called off already, or is over.
        """
        return self._loop.run(self._awaited.cancel_dispatch(id))

    def cancel_follow(self, id: str) -> models.FollowView:
        """Cancel a follow (operator). Before the drone follows: it is free again. 409 once it follows; stop it then."""
        return self._loop.run(self._awaited.cancel_follow(id))

    def cancel_recovery(self, id: str) -> models.RecoveryView:
        """Call a recovery off (operator). Its drones hold where they are, and whoever asked for it gets control of
        them; those that are descending already come down. Who gives no signs of life then has them come home, as
        always. 409 when it was called off already, or is over.
        """
        return self._loop.run(self._awaited.cancel_recovery(id))

    def cancel_run_waypoint(self, id: str, waypoint: str) -> models.RunView:
        """Cancel a waypoint of a mission run (operator)."""
        return self._loop.run(self._awaited.cancel_run_waypoint(id, waypoint))

    def change_follow(self, id: str, body: models.FollowPlaceRequest) -> models.FollowView:
        """Change where the drone stays (operator)."""
        return self._loop.run(self._awaited.change_follow(id, body))

    def change_password(self, body: models.PasswordRequest) -> None:
        """Change one's own password. Ends all other sessions of the user. After five wrong present passwords in a
        row: 429 for 30 s.
        """
        return self._loop.run(self._awaited.change_password(body))

    def change_user(self, name: str, body: models.UserChange) -> models.UserView:
        """Change a user's role, let a waiting one in, disable one. Disabling ends sessions and streams and makes
        access keys void until the user is active again.
        """
        return self._loop.run(self._awaited.change_user(name, body))

    def clear_fence(self, id: str) -> models.CommandView:
        """Take the fence away (operator)."""
        return self._loop.run(self._awaited.clear_fence(id))

    def clear_outlet_passphrase(self) -> None:
        """Take one's own signing passphrase away. Programs that use it are disconnected."""
        return self._loop.run(self._awaited.clear_outlet_passphrase())

    def clear_rally_points(self, id: str) -> models.CommandView:
        """Take the rally points away (operator)."""
        return self._loop.run(self._awaited.clear_rally_points(id))

    def close_outlet_port(self, id: str) -> None:
        """Close a personal port of one's own, or as an administrator anybody's."""
        return self._loop.run(self._awaited.close_outlet_port(id))

    def continue_follow(self, id: str) -> models.FollowView:
        """Let a follow go on (operator). After a pause, or when somebody else had the drone. 409 when it is not
        paused.
        """
        return self._loop.run(self._awaited.continue_follow(id))

    def continue_run(self, id: str) -> models.RunView:
        """Let a paused mission run go on (operator). All go on where they stopped. 409 when it is not paused."""
        return self._loop.run(self._awaited.continue_run(id))

    def delete_access_key(self, id: str) -> None:
        """Remove one of one's own access keys, with those made from it."""
        return self._loop.run(self._awaited.delete_access_key(id))

    def delete_dtls_key(self, identity: str) -> None:
        """Revoke the DTLS key of a vehicle; its links end at once (administrator)."""
        return self._loop.run(self._awaited.delete_dtls_key(identity))

    def delete_fleet(self, id: str) -> None:
        """Remove a fleet, with all grants of it."""
        return self._loop.run(self._awaited.delete_fleet(id))

    def delete_group(self, id: str) -> None:
        """Remove a group, with what was granted to it."""
        return self._loop.run(self._awaited.delete_group(id))

    def delete_link_key(self, id: str, *, vehicle: bool | None = None) -> models.LinkSecurityView:
        """Take the key off the vehicle (administrator). With vehicle=false it is forgotten here only. The policy
        becomes off. 202: still under way.
        """
        return self._loop.run(self._awaited.delete_link_key(id, vehicle=vehicle))

    def delete_log_file(self, id: str, number: int) -> None:
        """Remove the server's copy of a log (operator)."""
        return self._loop.run(self._awaited.delete_log_file(id, number))

    def delete_mission(self, id: str) -> None:
        """Remove a saved mission (operator)."""
        return self._loop.run(self._awaited.delete_mission(id))

    def delete_organisation(self, id: str) -> None:
        """Remove an organisation that has neither users nor drones."""
        return self._loop.run(self._awaited.delete_organisation(id))

    def delete_recording(self, id: str, *, confirm: bool | None = None) -> None:
        """Delete a recording for ever (operator)."""
        return self._loop.run(self._awaited.delete_recording(id, confirm=confirm))

    def delete_user(self, name: str) -> None:
        """Remove a user with sessions and keys."""
        return self._loop.run(self._awaited.delete_user(name))

    def delete_user_access_key(self, name: str, id: str) -> None:
        """Remove an access key of a user, with those made from it."""
        return self._loop.run(self._awaited.delete_user_access_key(name, id))

    def delete_zone(self, id: str) -> None:
        """Remove a zone (supervisor)."""
        return self._loop.run(self._awaited.delete_zone(id))

    def disconnect_outlet_client(self, id: str) -> None:
        """Disconnect what is attached (administrator). It may attach again after a minute; taking the passphrase
        away, or disabling the user, is what keeps it out.
        """
        return self._loop.run(self._awaited.disconnect_outlet_client(id))

    def dismiss_waiting(self, id: str) -> None:
        """Take a vehicle off the list (administrator). It comes again when it is heard."""
        return self._loop.run(self._awaited.dismiss_waiting(id))

    def download_log(self, id: str, number: int) -> models.CommandView:
        """Fetch a log from the vehicle (operator). The command's progress counts bytes and is streamed; a later
        attempt goes on where one ended.
        """
        return self._loop.run(self._awaited.download_log(id, number))

    def enrol_waiting(self, id: str, body: models.EnrolRequest | None = None) -> models.DroneView:
        """Let a vehicle in as a drone (administrator)."""
        return self._loop.run(self._awaited.enrol_waiting(id, body))

    def export_audit(
        self,
        *,
        user: str | None = None,
        drone: str | None = None,
        operation: str | None = None,
        face: str | None = None,
        outcome: str | None = None,
        from_: str | None = None,
        until: str | None = None,
        form: str | None = None,
    ) -> bytes:
        """Take all that are looked for along as a file (supervisor). form: csv, or jsonl for a line of JSON each.
        Newest first.
        """
        return self._loop.run(
            self._awaited.export_audit(
                user=user,
                drone=drone,
                operation=operation,
                face=face,
                outcome=outcome,
                from_=from_,
                until=until,
                form=form,
            )
        )

    def export_drone_telemetry(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
        form: str | None = None,
    ) -> bytes:
        """Take telemetry along as a file. form: csv, geojson, kml, gpx, parquet (the columns of the archive) or tlog
        (where it was recorded).
        """
        return self._loop.run(
            self._awaited.export_drone_telemetry(
                id, from_=from_, until=until, fields=fields, slots=slots, most=most, form=form
            )
        )

    def export_flight_telemetry(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
        form: str | None = None,
    ) -> bytes:
        """Take a flight along as a file. form: csv, geojson, kml, gpx, parquet (the columns of the archive) or tlog
        (where it was recorded).
        """
        return self._loop.run(
            self._awaited.export_flight_telemetry(
                id, from_=from_, until=until, fields=fields, slots=slots, most=most, form=form
            )
        )

    def export_logbook(
        self,
        *,
        drone: str | None = None,
        user: str | None = None,
        from_: str | None = None,
        until: str | None = None,
        words: str | None = None,
    ) -> bytes:
        """Take all flights that are looked for along as a table (CSV)."""
        return self._loop.run(
            self._awaited.export_logbook(drone=drone, user=user, from_=from_, until=until, words=words)
        )

    def export_parameters(self, id: str, *, form: str | None = None) -> bytes:
        """Save the parameters as a file. form: list (the default; Mission Planner, MAVProxy) or table
        (QGroundControl).
        """
        return self._loop.run(self._awaited.export_parameters(id, form=form))

    def finish_sign_in_elsewhere(self, *, code: str | None = None, state: str | None = None) -> str:
        """Come back from the provider. For browsers; leads to the page."""
        return self._loop.run(self._awaited.finish_sign_in_elsewhere(code=code, state=state))

    def follow_events(
        self,
        *,
        after: str | None = None,
        limit: int | None = None,
        drones: str | None = None,
        wait: float | None = None,
    ) -> models.FollowedEvents:
        """Follow what happens to drones. In the order in which it was stored; go on with after = next. With wait,
        the answer comes as soon as there is an event, or without one after that time. Where events are missing,
        gaps says so.
        """
        return self._loop.run(self._awaited.follow_events(after=after, limit=limit, drones=drones, wait=wait))

    def get_audit_receipt(self) -> models.ReceiptView:
        """Get a receipt for all records up to now (supervisor). Kept outside of the server, it shows later whether
        any of them was changed or removed, even by whoever runs the server.
        """
        return self._loop.run(self._awaited.get_audit_receipt())

    def get_command(self, id: str) -> models.CommandView:
        """Look at one command."""
        return self._loop.run(self._awaited.get_command(id))

    def get_control(self, id: str) -> models.ControlView:
        """See who has control."""
        return self._loop.run(self._awaited.get_control(id))

    def get_dispatch(self, id: str) -> models.DispatchView:
        """Look at one drone that was sent."""
        return self._loop.run(self._awaited.get_dispatch(id))

    def get_drone(self, id: str) -> models.DroneView:
        """Look at one drone."""
        return self._loop.run(self._awaited.get_drone(id))

    def get_drone_telemetry(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.SeriesView:
        """Look at numbers over time. For each of the fields the least and the greatest value of each slot, 1000
        slots unless asked otherwise (1 to 5000); at most 31 days.
        """
        return self._loop.run(
            self._awaited.get_drone_telemetry(id, from_=from_, until=until, fields=fields, slots=slots, most=most)
        )

    def get_endpoint(self, id: str) -> models.EndpointView:
        """Look at one endpoint (administrator)."""
        return self._loop.run(self._awaited.get_endpoint(id))

    def get_fence(self, id: str) -> models.FenceView:
        """Look at the fence. As last read from the vehicle; null until it first was."""
        return self._loop.run(self._awaited.get_fence(id))

    def get_flight(self, id: str) -> models.FlightView:
        """Look at one flight."""
        return self._loop.run(self._awaited.get_flight(id))

    def get_flight_telemetry(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.SeriesView:
        """Look at numbers over a flight. For each of the fields the least and the greatest value of each slot, 1000
        slots unless asked otherwise (1 to 5000); from and until make it a part of the flight.
        """
        return self._loop.run(
            self._awaited.get_flight_telemetry(id, from_=from_, until=until, fields=fields, slots=slots, most=most)
        )

    def get_follow(self, id: str) -> models.FollowView:
        """Look at one follow."""
        return self._loop.run(self._awaited.get_follow(id))

    def get_health(self) -> models.HealthView:
        """Is the server well? (no sign-in). ready counts the drones that can be armed."""
        return self._loop.run(self._awaited.get_health())

    def get_health_parts(self) -> models.HealthDetails:
        """How each part of the server is, and why it ended last (administrator)."""
        return self._loop.run(self._awaited.get_health_parts())

    def get_history(self) -> models.HistoryView:
        """Is all that drones do written down? (administrator)."""
        return self._loop.run(self._awaited.get_history())

    def get_link_security(self, id: str) -> models.LinkSecurityView:
        """Look at how a drone's link is secured, and what was refused."""
        return self._loop.run(self._awaited.get_link_security(id))

    def get_log_file(self, id: str, number: int) -> bytes:
        """Save a log that was fetched."""
        return self._loop.run(self._awaited.get_log_file(id, number))

    def get_mission(self, id: str) -> models.SavedMissionView:
        """Look at one saved mission."""
        return self._loop.run(self._awaited.get_mission(id))

    def get_outlet(self) -> models.OwnOutletView:
        """Where to attach, whether a passphrase is set, and one's own programs that are attached."""
        return self._loop.run(self._awaited.get_outlet())

    def get_plan(self, id: str) -> models.PlanView:
        """Look at one plan. How far the search is, and once it is finished who flies where and when."""
        return self._loop.run(self._awaited.get_plan(id))

    def get_prospects(self, id: str) -> models.WarehouseProspectsView:
        """What would follow if a drone were put into the warehouse (operator). What waits for a drone, the first in
        turn first, and what this one would arm and take off for at once. The same follows when control of a drone
        of the warehouse is given back. Changes nothing.
        """
        return self._loop.run(self._awaited.get_prospects(id))

    def get_rally_points(self, id: str) -> models.FenceRallyView:
        """Look at the rally points. As last read; null until they first were."""
        return self._loop.run(self._awaited.get_rally_points(id))

    def get_recording(self, id: str) -> models.RecordingView:
        """Look at one recording."""
        return self._loop.run(self._awaited.get_recording(id))

    def get_recording_file(self, id: str) -> bytes:
        """Download a recording. While the flight goes on: all that was heard so far. A tlog, which other programs
        read, or of robots a line of JSON for each message (.jsonl).
        """
        return self._loop.run(self._awaited.get_recording_file(id))

    def get_recording_sent(self, id: str) -> bytes:
        """Download who sent what in a recording (tab-separated). A line for each frame that went to the vehicle: its
        place in the file of the recording (bytes), the command that it was sent for, the epoch of control, and
        the user.
        """
        return self._loop.run(self._awaited.get_recording_sent(id))

    def get_recovery(self, id: str) -> models.RecoveryView:
        """Look at one recovery."""
        return self._loop.run(self._awaited.get_recovery(id))

    def get_registration_policy(self) -> models.RegistrationPolicy:
        """How accounts are made here. approval, invitation or off; needs no sign-in."""
        return self._loop.run(self._awaited.get_registration_policy())

    def get_replay(self, id: str) -> models.ReplayView:
        """Look at one replay."""
        return self._loop.run(self._awaited.get_replay(id))

    def get_run(self, id: str) -> models.RunView:
        """Look at one mission run. How it stands with each waypoint and drone, and what was decided why."""
        return self._loop.run(self._awaited.get_run(id))

    def get_run_journal(self, id: str, *, from_: int | None = None) -> models.RunJournalView:
        """Read the journal of a mission run (operator). All that befell it and what it decided, up to 200 entries at
        once.
        """
        return self._loop.run(self._awaited.get_run_journal(id, from_=from_))

    def get_sensed(self, id: str) -> models.SensedView:
        """Look at what its sensors brought last. Each kind is counted; the drone in the stream says the newest
        numbers.
        """
        return self._loop.run(self._awaited.get_sensed(id))

    def get_sensed_map(self, id: str) -> bytes:
        """Its map, drawn from above. JPEG or PNG; 204 when there was none yet."""
        return self._loop.run(self._awaited.get_sensed_map(id))

    def get_sensed_picture(self, id: str) -> bytes:
        """The newest picture of its camera. JPEG or PNG; 204 when there was none yet."""
        return self._loop.run(self._awaited.get_sensed_picture(id))

    def get_session(self) -> models.SessionView:
        """Who is signed in."""
        return self._loop.run(self._awaited.get_session())

    def get_settings(self) -> models.SettingsView:
        """What a client has to know of the server."""
        return self._loop.run(self._awaited.get_settings())

    def get_traffic(self) -> models.LinkTraffic:
        """What went over the link of each vehicle (administrator)."""
        return self._loop.run(self._awaited.get_traffic())

    def get_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Look at one virtual drone."""
        return self._loop.run(self._awaited.get_virtual_drone(id))

    def get_zone(self, id: str) -> models.ZoneFeature:
        """Look at one zone."""
        return self._loop.run(self._awaited.get_zone(id))

    def give_command(self, id: str, body: models.CommandRequest, *, wait: float | None = None) -> models.CommandView:
        """Give a command (operator). 202 with the command under way; with wait: 200 with its outcome if it ends in
        that time. 409 when the drone's state does not allow it, with the sentence why.
        """
        return self._loop.run(self._awaited.give_command(id, body, wait=wait))

    def give_drone(self, id: str, drone: str, body: models.GiftRequest | None = None) -> models.GiftView:
        """Give a drone of your own organisation to another one. On the ground, disarmed, and out of every operation
        and the warehouse. Only its new owners see it from then on. Flights, recordings, commands and telemetry of
        before stay with those who had it, and go along as well if histories says so, but never with names of
        people. What is on board goes along, and the keys of the vehicle still hold: change them.
        """
        return self._loop.run(self._awaited.give_drone(id, drone, body))

    def give_up_run_drone(self, id: str, drone: str) -> models.RunView:
        """Take a drone out of a mission run (operator). It is called home, and others fly its waypoints."""
        return self._loop.run(self._awaited.give_up_run_drone(id, drone))

    def grant_control(self, id: str, body: models.ControlGrantRequest) -> models.ControlView:
        """Give control to somebody who asks for it (holder)."""
        return self._loop.run(self._awaited.grant_control(id, body))

    def hand_over_control(self, id: str, body: models.ControlHandOverRequest) -> models.ControlView:
        """Give control to somebody (holder). They keep it for 30 s, or by using it."""
        return self._loop.run(self._awaited.hand_over_control(id, body))

    def import_parameters(self, id: str, body: bytes, *, dry_run: bool | None = None) -> models.ParametersFileView:
        """Compare with a file, or load it (operator). The body is the file as text/plain, in either form, up to 1
        MB. With dryRun=true nothing is sent; else what differs is changed and read back.
        """
        return self._loop.run(self._awaited.import_parameters(id, body, dry_run=dry_run))

    def import_zones(
        self,
        body: bytes,
        *,
        content_type: Literal[
            "application/geo+json", "application/vnd.google-earth.kml+xml", "application/vnd.google-earth.kmz"
        ],
    ) -> models.ZoneImportView:
        """Add the zones of a GeoJSON, KML or KMZ file (supervisor). Up to 4 MB. What cannot be a zone, such as a
        line, is left out and named with the reason, and the rest is added; a file without any is refused. Members
        of other programs are passed over, a MultiPolygon becomes several zones, what has no name gets one.
        """
        return self._loop.run(self._awaited.import_zones(body, content_type=content_type))

    def install_link_key(
        self, id: str, body: models.LinkSecurityChangeRequest | None = None
    ) -> models.LinkSecurityView:
        """Give the vehicle its key and hear that it signs (administrator). Over a safe link only, unless confirmed.
        202: still under way.
        """
        return self._loop.run(self._awaited.install_link_key(id, body))

    def issue_robot_key(self, body: models.RobotKeyRequest) -> models.RobotKeyView:
        """Issue the key of a robot (administrator). The key is in this answer and never shown again. With "drone" it
        replaces that robot's key, and the one before is void at once.
        """
        return self._loop.run(self._awaited.issue_robot_key(body))

    def join_run(self, id: str, body: models.RunJoinRequest) -> models.RunView:
        """Have a further drone join a mission run (operator). One that stands on the ground and that nobody else has
        control of.
        """
        return self._loop.run(self._awaited.join_run(id, body))

    def keep_control(self, id: str, body: models.ControlHeartbeatRequest) -> models.ControlView:
        """Say that the holder is there (holder). Every 2 s; lost after 6 s without."""
        return self._loop.run(self._awaited.keep_control(id, body))

    def list_access_keys(self) -> models.AccessKeys:
        """List one's own access keys."""
        return self._loop.run(self._awaited.list_access_keys())

    def list_commands(self, id: str) -> models.Commands:
        """List a drone's last commands. Newest first, at most 50."""
        return self._loop.run(self._awaited.list_commands(id))

    def list_dispatches(self) -> models.DispatchList:
        """List drones that were sent. Yours, and those of your organisation whose drones you all see: under way, and
        the newest that are over.
        """
        return self._loop.run(self._awaited.list_dispatches())

    def list_drone_events(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.Events:
        """Look at what happened to a drone. Oldest first, at most 5000."""
        return self._loop.run(
            self._awaited.list_drone_events(id, from_=from_, until=until, fields=fields, slots=slots, most=most)
        )

    def list_drone_telemetry_points(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.Points:
        """Look at states over time. All that are kept, or when these are more than most (1 to 20000, usually 5000),
        so many evenly over the time.
        """
        return self._loop.run(
            self._awaited.list_drone_telemetry_points(
                id, from_=from_, until=until, fields=fields, slots=slots, most=most
            )
        )

    def list_drones(self, *, active: bool | None = None) -> models.Drones:
        """List the drones."""
        return self._loop.run(self._awaited.list_drones(active=active))

    def list_dtls_keys(self) -> models.DtlsKeys:
        """List the DTLS keys of vehicles (administrator)."""
        return self._loop.run(self._awaited.list_dtls_keys())

    def list_endpoints(self) -> models.Endpoints:
        """List the endpoints with their state and counters (administrator)."""
        return self._loop.run(self._awaited.list_endpoints())

    def list_fleets(self) -> models.Fleets:
        """List the fleets."""
        return self._loop.run(self._awaited.list_fleets())

    def list_flight_events(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.Events:
        """Look at what happened in a flight. Messages, modes, commands with their outcomes and so on, from ten
        seconds before to ten after.
        """
        return self._loop.run(
            self._awaited.list_flight_events(id, from_=from_, until=until, fields=fields, slots=slots, most=most)
        )

    def list_flight_telemetry_points(
        self,
        id: str,
        *,
        from_: str | None = None,
        until: str | None = None,
        fields: str | None = None,
        slots: str | None = None,
        most: str | None = None,
    ) -> models.Points:
        """Look at the states of a flight. All that are kept, or when these are more than most (1 to 20000, usually
        5000), so many evenly over the time.
        """
        return self._loop.run(
            self._awaited.list_flight_telemetry_points(
                id, from_=from_, until=until, fields=fields, slots=slots, most=most
            )
        )

    def list_flights(
        self,
        *,
        drone: str | None = None,
        user: str | None = None,
        from_: str | None = None,
        until: str | None = None,
        words: str | None = None,
        before: str | None = None,
        limit: int | None = None,
    ) -> models.Flights:
        """Look for flights. Newest first, 50 unless limit says otherwise (1 to 200); go on with before = next. Times
        are as 2026-03-04T05:06:07Z.
        """
        return self._loop.run(
            self._awaited.list_flights(
                drone=drone, user=user, from_=from_, until=until, words=words, before=before, limit=limit
            )
        )

    def list_follows(self) -> models.FollowList:
        """List follows. Those of your organisation whose drones you see: under way, and the newest that are over."""
        return self._loop.run(self._awaited.list_follows())

    def list_given_drones(self, id: str) -> models.Gifts:
        """List the drones that were given to an organisation and that it still has. As they were called when they
        were given.
        """
        return self._loop.run(self._awaited.list_given_drones(id))

    def list_grants(self) -> models.Grants:
        """List the grants."""
        return self._loop.run(self._awaited.list_grants())

    def list_groups(self) -> models.Groups:
        """List the groups of users."""
        return self._loop.run(self._awaited.list_groups())

    def list_invitations(self) -> models.Invitations:
        """List the open invitations."""
        return self._loop.run(self._awaited.list_invitations())

    def list_left_behind(self) -> models.LeftBehind:
        """List removed drones with what their owners had set (administrator). What the cloud had changed on them was
        not put back before they were removed.
        """
        return self._loop.run(self._awaited.list_left_behind())

    def list_logs(self, id: str) -> models.LogsView:
        """List the logs on board. As last listed; null until they first were."""
        return self._loop.run(self._awaited.list_logs(id))

    def list_missions(self) -> models.Missions:
        """List the saved missions."""
        return self._loop.run(self._awaited.list_missions())

    def list_organisations(self) -> models.Organisations:
        """List the organisations. With how many users and drones each has."""
        return self._loop.run(self._awaited.list_organisations())

    def list_outlet_clients(self) -> models.OutletView:
        """List all that is attached, and what was refused (administrator)."""
        return self._loop.run(self._awaited.list_outlet_clients())

    def list_parameters(self, id: str, *, search: str | None = None) -> models.ParametersView:
        """List or search the parameters. As last heard from the vehicle; readAt is null until they were first read."""
        return self._loop.run(self._awaited.list_parameters(id, search=search))

    def list_plans(self) -> models.PlanList:
        """List your plans. Without their ways. Forgotten an hour after they ended."""
        return self._loop.run(self._awaited.list_plans())

    def list_recordings(self, *, drone: str | None = None) -> models.RecordingPage:
        """List the recordings, newest first, and the room that they take."""
        return self._loop.run(self._awaited.list_recordings(drone=drone))

    def list_recoveries(self) -> models.RecoveryList:
        """List recoveries. Yours, and those of your organisation whose drones you all see: under way, and the newest
        that are over.
        """
        return self._loop.run(self._awaited.list_recoveries())

    def list_replays(self) -> models.Replays:
        """List the replays."""
        return self._loop.run(self._awaited.list_replays())

    def list_robot_keys(self) -> models.RobotKeys:
        """List the keys of robots (administrator)."""
        return self._loop.run(self._awaited.list_robot_keys())

    def list_runs(self) -> models.RunList:
        """List mission runs. Those of your organisation all of whose drones you see: under way, and the newest that
        are over. Forgotten 90 days after their end.
        """
        return self._loop.run(self._awaited.list_runs())

    def list_user_access_keys(self, name: str) -> models.AccessKeys:
        """List a user's access keys. What they may do and when they were last used."""
        return self._loop.run(self._awaited.list_user_access_keys(name))

    def list_users(self) -> models.Users:
        """List the users. With those who wait until they are let in."""
        return self._loop.run(self._awaited.list_users())

    def list_virtual_drones(self) -> models.VirtualDroneList:
        """List your virtual drones. Supervisors see those of all users."""
        return self._loop.run(self._awaited.list_virtual_drones())

    def list_waiting(self) -> models.Waitings:
        """List the vehicles that wait (administrator)."""
        return self._loop.run(self._awaited.list_waiting())

    def list_warehouse(self) -> models.WarehouseView:
        """List the drones of the warehouse. Those that you may see."""
        return self._loop.run(self._awaited.list_warehouse())

    def list_zones(self) -> models.ZoneCollection:
        """List the zones. A GeoJSON FeatureCollection."""
        return self._loop.run(self._awaited.list_zones())

    def make_access_key(self, body: models.KeyRequest) -> models.KeyView:
        """Make an access key. The key itself is in this answer and never shown again. What is left out is as wide as
        you are; made with a key, it stays within that key and goes with it.
        """
        return self._loop.run(self._awaited.make_access_key(body))

    def make_backup(self) -> bytes:
        """Make a backup (administrator). The answer is a zip of all that is stored."""
        return self._loop.run(self._awaited.make_backup())

    def make_dtls_key(self, body: models.DtlsKeyRequest) -> models.DtlsKeyView:
        """Make the DTLS key of a vehicle (administrator). The secret is in this answer and never shown again; a
        drone's key before is void.
        """
        return self._loop.run(self._awaited.make_dtls_key(body))

    def make_link_key(self, id: str, body: models.LinkKeyRequest) -> models.MadeLinkKey:
        """Make a key, or bring one along (administrator). The key is in this answer and never shown again; it is not
        on the vehicle yet.
        """
        return self._loop.run(self._awaited.make_link_key(id, body))

    def make_plan(self, body: models.PlanRequest) -> models.PlanView:
        """Ask for a plan (planner). Answered at once; look at it until it is finished, or hear of it on the stream.
        Where drones are, their homes, batteries, links and kinds are those that the cloud knows now: whatever is
        not known is said. 503 when too many wait already.
        """
        return self._loop.run(self._awaited.make_plan(body))

    def make_stream_ticket(self) -> models.StreamTicket:
        """Get a ticket for the stream. Good for one connection within 30 s."""
        return self._loop.run(self._awaited.make_stream_ticket())

    def move_run_waypoint(self, id: str, waypoint: str, body: models.RunMoveRequest) -> models.RunView:
        """Move a waypoint of a mission run (operator). What is left out of latitude, longitude and altitude stays;
        one of them is needed.
        """
        return self._loop.run(self._awaited.move_run_waypoint(id, waypoint, body))

    def open_follow(self, body: models.FollowOpenRequest) -> models.FollowView:
        """Ask to be followed (operator). Chooses the drone of the warehouse that is nearest and has enough in its
        battery, or takes the one that is named, and keeps it. 409 with why each cannot, when none can.
        """
        return self._loop.run(self._awaited.open_follow(body))

    def open_outlet_port(self, body: models.OutletPortRequest) -> models.OutletPortView:
        """Open a personal port, view-only, for a program that cannot sign. The first to speak there from that
        address or network has it, until it is closed, its hours are over or the server is restarted. It shows
        unsigned what you may see; nothing sent there changes anything.
        """
        return self._loop.run(self._awaited.open_outlet_port(body))

    def order_tour(self, body: models.TourRequest) -> models.TourView:
        """Put the waypoints of one drone into a good order (planner). From where the drone is, round the zones that
        bind it; nothing is sent to it. Answered after the seconds of the search, at once where there are few
        waypoints. 409 while another one of yours is under way; 503 when too many wait already.
        """
        return self._loop.run(self._awaited.order_tour(body))

    def pause_follow(self, id: str) -> models.FollowView:
        """Pause a follow (operator). The drone stays where it is, in the air. 409 when it does not follow."""
        return self._loop.run(self._awaited.pause_follow(id))

    def pause_run(self, id: str) -> models.RunView:
        """Pause a mission run (operator). Its drones in the air hold where they are, those on the ground stay there;
        who is on its way home, or has nothing left to visit, comes down. 409 when it is paused already.
        """
        return self._loop.run(self._awaited.pause_run(id))

    def preview_recovery(self, body: models.RecoveryRequest) -> models.RecoveryPreview:
        """Preview a recovery (operator). What the same request would do if it were begun now: which drones come, at
        which height, in which order, and where each comes down; and which are left alone, with the reason.
        Nothing is commanded. 409 when they do not fit, with the number that does.
        """
        return self._loop.run(self._awaited.preview_recovery(body))

    def put_into_warehouse(self, id: str) -> models.WarehouseView:
        """Let a drone serve virtual ones (supervisor)."""
        return self._loop.run(self._awaited.put_into_warehouse(id))

    def read_fence(self, id: str) -> models.CommandView:
        """Read the fence from the vehicle (operator)."""
        return self._loop.run(self._awaited.read_fence(id))

    def read_logs(self, id: str) -> models.CommandView:
        """Ask the vehicle for the list of its logs (operator)."""
        return self._loop.run(self._awaited.read_logs(id))

    def read_parameters(self, id: str, *, wait: float | None = None) -> models.CommandView:
        """Read all parameters from the vehicle (operator). Its progress is streamed."""
        return self._loop.run(self._awaited.read_parameters(id, wait=wait))

    def read_rally_points(self, id: str) -> models.CommandView:
        """Read the rally points from the vehicle (operator)."""
        return self._loop.run(self._awaited.read_rally_points(id))

    def refuse_control(self, id: str, body: models.ControlRefuseRequest) -> models.ControlView:
        """Keep control from somebody who asks for it (holder)."""
        return self._loop.run(self._awaited.refuse_control(id, body))

    def register(self, body: models.RegistrationRequest) -> models.RegistrationAnswer:
        """Ask for an account. Needs no sign-in. 201: with an invitation, sign in now. 202: an administrator decides.
        At most ten from one address in ten minutes.
        """
        return self._loop.run(self._awaited.register(body))

    def release_control(self, id: str) -> models.ControlView:
        """Give control back (holder)."""
        return self._loop.run(self._awaited.release_control(id))

    def remove_drone(self, id: str) -> None:
        """Forget a lost drone (administrator)."""
        return self._loop.run(self._awaited.remove_drone(id))

    def remove_endpoint(self, id: str) -> None:
        """Remove an endpoint that was added (administrator)."""
        return self._loop.run(self._awaited.remove_endpoint(id))

    def remove_plan(self, id: str) -> None:
        """Cancel or forget a plan (planner). Cancels one that is queued or running; forgets one that has ended."""
        return self._loop.run(self._awaited.remove_plan(id))

    def remove_replay(self, id: str) -> None:
        """End a replay and remove its drones (operator)."""
        return self._loop.run(self._awaited.remove_replay(id))

    def remove_virtual_drone(self, id: str) -> None:
        """Remove a virtual drone (planner). Only while its mission is not under way."""
        return self._loop.run(self._awaited.remove_virtual_drone(id))

    def rename_drone(self, id: str, body: models.RenameRequest) -> models.DroneView:
        """Give a drone another name (operator)."""
        return self._loop.run(self._awaited.rename_drone(id, body))

    def rename_organisation(self, id: str, body: models.OrganisationNameRequest) -> models.OrganisationView:
        """Rename an organisation."""
        return self._loop.run(self._awaited.rename_organisation(id, body))

    def renew_access_key(self, id: str) -> models.KeyView:
        """Renew an access key. The same key with a new secret, which is in this answer and never shown again; the
        old one is void at once. Keys made from it stay.
        """
        return self._loop.run(self._awaited.renew_access_key(id))

    def replace_fleet(self, id: str, body: models.FleetRequest) -> models.FleetView:
        """Change the name and the drones of a fleet."""
        return self._loop.run(self._awaited.replace_fleet(id, body))

    def replace_group(self, id: str, body: models.GroupRequest) -> models.GroupView:
        """Change the name and the members of a group."""
        return self._loop.run(self._awaited.replace_group(id, body))

    def replace_mission(self, id: str, body: models.MissionRequest) -> models.SavedMissionView:
        """Replace a saved mission (operator)."""
        return self._loop.run(self._awaited.replace_mission(id, body))

    def replace_virtual_drone(self, id: str, body: models.VirtualDroneRequest) -> models.VirtualDroneView:
        """Name it, say what it needs, plan its mission (planner). Holds from the next start on. No drone needs to be
        there.
        """
        return self._loop.run(self._awaited.replace_virtual_drone(id, body))

    def replace_zone(self, id: str, body: models.ZoneFeature) -> models.ZoneFeature:
        """Replace a zone (supervisor). Binds at once, drones in flight too."""
        return self._loop.run(self._awaited.replace_zone(id, body))

    def replay_recording(self, id: str, *, speed: float | None = None) -> models.ReplayView:
        """Play a recording on the map (operator)."""
        return self._loop.run(self._awaited.replay_recording(id, speed=speed))

    def replay_run_journal(self, id: str) -> models.RunReplayView:
        """Replay the journal of a mission run (operator). Decides once more on all that befell it, and tells the
        first decision that differs by a letter.
        """
        return self._loop.run(self._awaited.replay_run_journal(id))

    def report_follow_positions(self, id: str, body: models.FollowPositionsRequest) -> models.FollowReceipt:
        """Say where the phone is (operator). Once a second or so. What was said before may be said again: it counts
        once. Only the user who asked to be followed says that. 409 when the follow is over.
        """
        return self._loop.run(self._awaited.report_follow_positions(id, body))

    def request_control(self, id: str, body: models.ControlAskRequest | None = None) -> models.ControlView:
        """Ask the holder for control (operator). 202 while the holder decides, for up to a minute; 200 where control
        was free.
        """
        return self._loop.run(self._awaited.request_control(id, body))

    def reset_password(self, name: str) -> models.OneTimePassword:
        """Give a user a one-time password. It is in this answer and never shown again; it serves until the user has
        taken another one.
        """
        return self._loop.run(self._awaited.reset_password(name))

    def resume_run_drone(self, id: str, drone: str) -> models.RunView:
        """Give a drone back to its mission run (operator). One that a pilot or somebody else took. Nothing else
        gives control back to the run.
        """
        return self._loop.run(self._awaited.resume_run_drone(id, drone))

    def resume_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Go on with what is not flown yet (operator). After somebody who goes first took the drone, or drone after
        drone could not go on. Of several shares all go on that wait for it.
        """
        return self._loop.run(self._awaited.resume_virtual_drone(id))

    def revoke_grant(self, id: str) -> None:
        """Take a grant back. At once, on open streams too."""
        return self._loop.run(self._awaited.revoke_grant(id))

    def revoke_robot_key(self, id: str) -> None:
        """Revoke the key of a robot (administrator). Its links end at once. Its drone stays, with all that is known
        of it.
        """
        return self._loop.run(self._awaited.revoke_robot_key(id))

    def rotate_link_key(self, id: str, body: models.LinkSecurityChangeRequest | None = None) -> models.LinkSecurityView:
        """Change the vehicle over to a new key (administrator). Both keys are accepted meanwhile; on failure the old
        one stays. 202: still under way.
        """
        return self._loop.run(self._awaited.rotate_link_key(id, body))

    def search_audit(
        self,
        *,
        user: str | None = None,
        drone: str | None = None,
        operation: str | None = None,
        face: str | None = None,
        outcome: str | None = None,
        from_: str | None = None,
        until: str | None = None,
        before: int | None = None,
        limit: int | None = None,
    ) -> models.AuditPage:
        """Look for records (supervisor). Newest first, 50 unless limit says otherwise (1 to 200); go on with before
        = next. Times are as 2026-03-04T05:06:07Z.
        """
        return self._loop.run(
            self._awaited.search_audit(
                user=user,
                drone=drone,
                operation=operation,
                face=face,
                outcome=outcome,
                from_=from_,
                until=until,
                before=before,
                limit=limit,
            )
        )

    def send_drone(self, body: models.DispatchRequest) -> models.DispatchView:
        """Send a drone here (operator). Of the drones of the pool that you may command, the nearest that can come is
        chosen: it is free, zones let it go there and back, its battery lasts with a reserve, its link is good,
        and it can hover. It starts at once. When it is there, you have control of it, as if you had taken it:
        give signs of life from then on, within 20 s, or it holds and flies home. 409 with why each cannot, when
        none can.
        """
        return self._loop.run(self._awaited.send_drone(body))

    def set_fence(self, id: str, body: models.FenceView) -> models.CommandView:
        """Replace the fence (operator). Up to 500 polygons and circles with together 2000 corners, and a return
        point; how many of them a vehicle takes is its own. What was read with something left out is refused.
        """
        return self._loop.run(self._awaited.set_fence(id, body))

    def set_fence_from_zones(self, id: str) -> models.CommandView:
        """Make the cloud's zones the vehicle's own fence (planner). All zones without floor and ceiling that bind
        this drone now, whoever flies it; they then hold also where the vehicle does not hear the cloud. Zones
        that a vehicle cannot keep are named among the warnings. What was its fence before is replaced.
        """
        return self._loop.run(self._awaited.set_fence_from_zones(id))

    def set_group_only_granted(self, id: str, body: models.OnlyGrantedRequest) -> None:
        """Let the members of a group see only what was granted, or all drones by their role."""
        return self._loop.run(self._awaited.set_group_only_granted(id, body))

    def set_link_security(self, id: str, body: models.LinkSecurityPolicyRequest) -> models.LinkSecurityView:
        """Set the policy: off, optional or required (administrator)."""
        return self._loop.run(self._awaited.set_link_security(id, body))

    def set_outlet_passphrase(self, body: models.PassphraseRequest) -> models.PassphraseView:
        """Set one's own signing passphrase. Without one given it is made up. It is in this answer and never shown
        again; programs that use the one before are disconnected.
        """
        return self._loop.run(self._awaited.set_outlet_passphrase(body))

    def set_parameter(
        self, id: str, name: str, body: models.ParameterValueRequest, *, wait: float | None = None
    ) -> models.CommandView:
        """Change a parameter (operator). It is read back: when the vehicle holds something else, the command fails
        and says what.
        """
        return self._loop.run(self._awaited.set_parameter(id, name, body, wait=wait))

    def set_rally_points(self, id: str, body: models.FenceRallyView) -> models.CommandView:
        """Replace the rally points (operator). Up to 250, each with what its altitude is measured from. What was
        read with something left out is refused.
        """
        return self._loop.run(self._awaited.set_rally_points(id, body))

    def set_user_only_granted(self, name: str, body: models.OnlyGrantedRequest) -> None:
        """Let a user see only what was granted, or all drones by the role."""
        return self._loop.run(self._awaited.set_user_only_granted(name, body))

    def sign_in(self, body: models.Credentials) -> models.SessionView:
        """Sign in. After five wrong passwords in a row: 429 for 30 s."""
        return self._loop.run(self._awaited.sign_in(body))

    def sign_out(self) -> None:
        """Sign out. Ends this session, and the streams that were opened with it."""
        return self._loop.run(self._awaited.sign_out())

    def sign_out_everywhere(self) -> None:
        """Sign out everywhere. Ends all one's own sessions, this one too, and their open streams; access keys stay."""
        return self._loop.run(self._awaited.sign_out_everywhere())

    def sign_out_user(self, name: str) -> None:
        """End all sessions of a user. Access keys stay; see those."""
        return self._loop.run(self._awaited.sign_out_user(name))

    def start_follow(self, id: str) -> models.FollowView:
        """Start following (operator). The drone takes off and comes. 409 when it was started already."""
        return self._loop.run(self._awaited.start_follow(id))

    def start_replay(self, body: bytes, *, speed: float | None = None, name: str | None = None) -> models.ReplayView:
        """Play a recording (operator). The body is the tlog, up to 512 MB, as application/octet-stream."""
        return self._loop.run(self._awaited.start_replay(body, speed=speed, name=name))

    def start_run(self, body: models.RunStartRequest) -> models.RunView:
        """Fly a plan (operator). Takes control of the plan's drones, brings them their missions, starts them and
        conducts them to the end. 409 when the plan must not be flown, or somebody has control of one of its
        drones.
        """
        return self._loop.run(self._awaited.start_run(body))

    def start_sign_in_elsewhere(self) -> str:
        """Go to the provider to sign in. For browsers; 404 when there is none."""
        return self._loop.run(self._awaited.start_sign_in_elsewhere())

    def start_virtual_drone(
        self, id: str, body: models.VirtualDroneStartRequest | None = None
    ) -> models.VirtualDroneView:
        """Have its mission flown (operator). By the best drone that is free, or by several where they may share it;
        else it waits, and its place in the queue is told.
        """
        return self._loop.run(self._awaited.start_virtual_drone(id, body))

    def stop_follow(self, id: str) -> models.FollowView:
        """Stop a follow (operator). The drone flies home; it is over when it is down."""
        return self._loop.run(self._awaited.stop_follow(id))

    def stop_plan(self, id: str) -> models.PlanView:
        """Stop the start of a plan (operator). Drones that have not been started yet are not started, and disarmed
        where they were armed for it. Drones that fly, fly on: call them back by their own commands. 409 when
        nothing is under way.
        """
        return self._loop.run(self._awaited.stop_plan(id))

    def stop_run(self, id: str) -> models.RunView:
        """Stop a mission run (operator). Its drones return; it is over when all are down."""
        return self._loop.run(self._awaited.stop_run(id))

    def stop_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Stop its mission (operator; supervisors any). All drones that serve it come home."""
        return self._loop.run(self._awaited.stop_virtual_drone(id))

    def take_back_drone(self, id: str, drone: str) -> models.GiftView:
        """Take a drone back that was given to an organisation. On the ground, disarmed, and out of every operation
        and the warehouse. What it did meanwhile is shown to those who had it then, alone.
        """
        return self._loop.run(self._awaited.take_back_drone(id, drone))

    def take_control(self, id: str) -> models.ControlView:
        """Take control where nobody has it (operator). Also back from the pilot at the vehicle. Send the heartbeat
        every 2 s from then on.
        """
        return self._loop.run(self._awaited.take_control(id))

    def take_from_warehouse(self, id: str) -> None:
        """Let a drone serve virtual ones no more (supervisor). What it serves now it serves to the end."""
        return self._loop.run(self._awaited.take_from_warehouse(id))

    def take_over_control(self, id: str, body: models.ControlTakeOverRequest) -> models.ControlView:
        """Take control from whoever has it, with a reason (supervisor)."""
        return self._loop.run(self._awaited.take_over_control(id, body))

    def verify_audit(self, body: models.ReceiptView | None = None) -> models.AuditVerdictView:
        """Verify all records, against a receipt too if one is sent (administrator). Names the first record that is
        not as it was.
        """
        return self._loop.run(self._awaited.verify_audit(body))

    def withdraw_invitation(self, id: str) -> None:
        """Withdraw an invitation."""
        return self._loop.run(self._awaited.withdraw_invitation(id))
