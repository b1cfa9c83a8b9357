"""A call for each operation of REST, awaited.

Written from the description of REST by `python -m generator`.
"""

# ruff: noqa: E501

from typing import Literal

from dronemap.contract import models
from dronemap.contract.call import Call, CallSender, placed


class Operations:
    """The operations of REST under their names; each raises a `Problem` when the server refuses it."""

    def __init__(self, sender: CallSender) -> None:
        self._sender = sender

    async def accept_plan(
        self, id: str, body: models.PlanAcceptRequest | None = None, *, wait: float | None = None
    ) -> models.PlanView:
        """Accept a plan (planner; to start it operator). Uploads each drone's mission: one outcome for each drone.
        With start the drones are armed and started, each when the plan says, once all have their missions. 200
        when nothing is under way any more, else 202. 409 when the plan must not be flown, or a drone has moved.
        """
        call = Call("acceptPlan", "POST", placed("/plans/{id}/accept", id=id), query={"wait": wait}, body=body)
        return await self._sender.send(call, models.PlanView)

    async def add_endpoint(self, body: models.EndpointRequest) -> models.EndpointView:
        """Add an endpoint (administrator). It stays over restarts. While it cannot open it is listed as failed, and
        tried again.
        """
        call = Call("addEndpoint", "POST", "/endpoints", body=body)
        return await self._sender.send(call, models.EndpointView)

    async def add_fleet(self, body: models.FleetRequest) -> models.FleetView:
        """Make a fleet of drones."""
        call = Call("addFleet", "POST", "/fleets", body=body)
        return await self._sender.send(call, models.FleetView)

    async def add_grant(self, body: models.GrantRequest) -> models.GrantView:
        """Grant something. To a user or a group; of drones, a fleet or all; operations of view, plan, command and
        administer. It takes from what a role allows, and binds those who see only what they were granted.
        """
        call = Call("addGrant", "POST", "/grants", body=body)
        return await self._sender.send(call, models.GrantView)

    async def add_group(self, body: models.GroupRequest) -> models.GroupView:
        """Make a group of users."""
        call = Call("addGroup", "POST", "/groups", body=body)
        return await self._sender.send(call, models.GroupView)

    async def add_invitation(self, body: models.NewInvitation) -> models.InvitationView:
        """Invite somebody. The code is in this answer and never shown again; it serves once. The page takes it as
        /#invitation=CODE.
        """
        call = Call("addInvitation", "POST", "/invitations", body=body)
        return await self._sender.send(call, models.InvitationView)

    async def add_mission(self, body: models.MissionRequest) -> models.SavedMissionView:
        """Save a mission (operator)."""
        call = Call("addMission", "POST", "/missions", body=body)
        return await self._sender.send(call, models.SavedMissionView)

    async def add_organisation(self, body: models.OrganisationNameRequest) -> models.OrganisationView:
        """Make an organisation. Its first administrator comes by an invitation into it (POST /invitations)."""
        call = Call("addOrganisation", "POST", "/organisations", body=body)
        return await self._sender.send(call, models.OrganisationView)

    async def add_run_barrier(self, id: str, body: models.ZoneFeature) -> models.RunView:
        """Add a zone to a mission run (operator). A GeoJSON feature as of a zone of the cloud; binds all drones of
        the run at once, until it is over.
        """
        call = Call("addRunBarrier", "POST", placed("/runs/{id}/barriers", id=id), body=body)
        return await self._sender.send(call, models.RunView)

    async def add_run_waypoints(self, id: str, body: models.RunWaypointsRequest) -> models.RunView:
        """Add waypoints to a mission run (operator). Shared out among the drones that fly."""
        call = Call("addRunWaypoints", "POST", placed("/runs/{id}/waypoints", id=id), body=body)
        return await self._sender.send(call, models.RunView)

    async def add_user(self, body: models.NewUser) -> models.UserView:
        """Add a user. The password serves for the first sign-in; the user then has to take another one."""
        call = Call("addUser", "POST", "/users", body=body)
        return await self._sender.send(call, models.UserView)

    async def add_virtual_drone(self, body: models.VirtualDroneRequest) -> models.VirtualDroneView:
        """Make a virtual drone (planner). With what it needs, and its mission if it is known."""
        call = Call("addVirtualDrone", "POST", "/virtual-drones", body=body)
        return await self._sender.send(call, models.VirtualDroneView)

    async def add_zone(self, body: models.ZoneFeature) -> models.ZoneFeature:
        """Add a zone (supervisor). A GeoJSON feature: a Polygon with one ring, or a Point with properties.radius."""
        call = Call("addZone", "POST", "/zones", body=body)
        return await self._sender.send(call, models.ZoneFeature)

    async def annotate_flight(self, id: str, body: models.FlightNotes) -> models.FlightView:
        """Write notes about a flight (operator)."""
        call = Call("annotateFlight", "PATCH", placed("/flights/{id}", id=id), body=body)
        return await self._sender.send(call, models.FlightView)

    async def answer_run(self, id: str, proposal: str, body: models.RunAnswerRequest) -> models.RunView:
        """Answer a proposal of a mission run (operator). By its number. 409 when another one waits by now, or none."""
        call = Call("answerRun", "POST", placed("/runs/{id}/answers/{proposal}", id=id, proposal=proposal), body=body)
        return await self._sender.send(call, models.RunView)

    async def begin_recovery(self, body: models.RecoveryRequest) -> models.RecoveryView:
        """Bring drones home, or down, together (operator). All stop where they are. Then each that returns climbs or
        descends to a height of its own, which is set as its return height too, and flies home in its turn; pads
        near each other are used one after the other. Each that lands does so where it is, one after the other
        where they are near. The return heights are put back on the ground. 409 when they do not fit between the
        lowest height and the ceiling, with the number that does, or when two would come down on one spot.
        """
        call = Call("beginRecovery", "POST", "/recoveries", body=body)
        return await self._sender.send(call, models.RecoveryView)

    async def broadcast_command(
        self, body: models.BroadcastRequest, *, wait: float | None = None
    ) -> models.BroadcastView:
        """Give one command to several drones or all (operator). One result for each drone, in the order asked: its
        command, refused, under way or ended. 200 when none is under way any more, else 202.
        """
        call = Call("broadcastCommand", "POST", "/commands", query={"wait": wait}, body=body)
        return await self._sender.send(call, models.BroadcastView)

    async def cancel_dispatch(self, id: str) -> models.DispatchView:
        """Call a drone off that was sent (operator). It flies home, also when it is there and you have control of
        it. 409 when it was called off already, or is over.
        """
        call = Call("cancelDispatch", "POST", placed("/dispatches/{id}/cancel", id=id))
        return await self._sender.send(call, models.DispatchView)

    async def cancel_follow(self, id: str) -> models.FollowView:
        """Cancel a follow (operator). Before the drone follows: it is free again. 409 once it follows; stop it then."""
        call = Call("cancelFollow", "POST", placed("/follows/{id}/cancel", id=id))
        return await self._sender.send(call, models.FollowView)

    async def cancel_recovery(self, id: str) -> models.RecoveryView:
        """Call a recovery off (operator). Its drones hold where they are, and whoever asked for it gets control of
        them; those that are descending already come down. Who gives no signs of life then has them come home, as
        always. 409 when it was called off already, or is over.
        """
        call = Call("cancelRecovery", "POST", placed("/recoveries/{id}/cancel", id=id))
        return await self._sender.send(call, models.RecoveryView)

    async def cancel_run_waypoint(self, id: str, waypoint: str) -> models.RunView:
        """Cancel a waypoint of a mission run (operator)."""
        call = Call("cancelRunWaypoint", "DELETE", placed("/runs/{id}/waypoints/{waypoint}", id=id, waypoint=waypoint))
        return await self._sender.send(call, models.RunView)

    async def change_follow(self, id: str, body: models.FollowPlaceRequest) -> models.FollowView:
        """Change where the drone stays (operator)."""
        call = Call("changeFollow", "PATCH", placed("/follows/{id}", id=id), body=body)
        return await self._sender.send(call, models.FollowView)

    async def change_password(self, body: models.PasswordRequest) -> None:
        """Change one's own password. Ends all other sessions of the user. After five wrong present passwords in a
        row: 429 for 30 s.
        """
        call = Call("changePassword", "POST", "/session/password", body=body)
        await self._sender.send(call, None)

    async def change_user(self, name: str, body: models.UserChange) -> models.UserView:
        """Change a user's role, let a waiting one in, disable one. Disabling ends sessions and streams and makes
        access keys void until the user is active again.
        """
        call = Call("changeUser", "PATCH", placed("/users/{name}", name=name), body=body)
        return await self._sender.send(call, models.UserView)

    async def clear_fence(self, id: str) -> models.CommandView:
        """Take the fence away (operator)."""
        call = Call("clearFence", "DELETE", placed("/drones/{id}/fence", id=id))
        return await self._sender.send(call, models.CommandView)

    async def clear_outlet_passphrase(self) -> None:
        """Take one's own signing passphrase away. Programs that use it are disconnected."""
        call = Call("clearOutletPassphrase", "DELETE", "/outlet/passphrase")
        await self._sender.send(call, None)

    async def clear_rally_points(self, id: str) -> models.CommandView:
        """Take the rally points away (operator)."""
        call = Call("clearRallyPoints", "DELETE", placed("/drones/{id}/rally-points", id=id))
        return await self._sender.send(call, models.CommandView)

    async def close_outlet_port(self, id: str) -> None:
        """Close a personal port of one's own, or as an administrator anybody's."""
        call = Call("closeOutletPort", "DELETE", placed("/outlet/ports/{id}", id=id))
        await self._sender.send(call, None)

    async def continue_follow(self, id: str) -> models.FollowView:
        """Let a follow go on (operator). After a pause, or when somebody else had the drone. 409 when it is not
        paused.
        """
        call = Call("continueFollow", "POST", placed("/follows/{id}/continue", id=id))
        return await self._sender.send(call, models.FollowView)

    async def continue_run(self, id: str) -> models.RunView:
        """Let a paused mission run go on (operator). All go on where they stopped. 409 when it is not paused."""
        call = Call("continueRun", "POST", placed("/runs/{id}/continue", id=id))
        return await self._sender.send(call, models.RunView)

    async def delete_access_key(self, id: str) -> None:
        """Remove one of one's own access keys, with those made from it."""
        call = Call("deleteAccessKey", "DELETE", placed("/access-keys/{id}", id=id))
        await self._sender.send(call, None)

    async def delete_dtls_key(self, identity: str) -> None:
        """Revoke the DTLS key of a vehicle; its links end at once (administrator)."""
        call = Call("deleteDtlsKey", "DELETE", placed("/dtls-keys/{identity}", identity=identity))
        await self._sender.send(call, None)

    async def delete_fleet(self, id: str) -> None:
        """Remove a fleet, with all grants of it."""
        call = Call("deleteFleet", "DELETE", placed("/fleets/{id}", id=id))
        await self._sender.send(call, None)

    async def delete_group(self, id: str) -> None:
        """Remove a group, with what was granted to it."""
        call = Call("deleteGroup", "DELETE", placed("/groups/{id}", id=id))
        await self._sender.send(call, None)

    async def delete_link_key(self, id: str, *, vehicle: bool | None = None) -> models.LinkSecurityView:
        """Take the key off the vehicle (administrator). With vehicle=false it is forgotten here only. The policy
        becomes off. 202: still under way.
        """
        call = Call("deleteLinkKey", "DELETE", placed("/drones/{id}/link-key", id=id), query={"vehicle": vehicle})
        return await self._sender.send(call, models.LinkSecurityView)

    async def delete_log_file(self, id: str, number: int) -> None:
        """Remove the server's copy of a log (operator)."""
        call = Call("deleteLogFile", "DELETE", placed("/drones/{id}/logs/{number}/file", id=id, number=number))
        await self._sender.send(call, None)

    async def delete_mission(self, id: str) -> None:
        """Remove a saved mission (operator)."""
        call = Call("deleteMission", "DELETE", placed("/missions/{id}", id=id))
        await self._sender.send(call, None)

    async def delete_organisation(self, id: str) -> None:
        """Remove an organisation that has neither users nor drones."""
        call = Call("deleteOrganisation", "DELETE", placed("/organisations/{id}", id=id))
        await self._sender.send(call, None)

    async def delete_recording(self, id: str, *, confirm: bool | None = None) -> None:
        """Delete a recording for ever (operator)."""
        call = Call("deleteRecording", "DELETE", placed("/recordings/{id}", id=id), query={"confirm": confirm})
        await self._sender.send(call, None)

    async def delete_user(self, name: str) -> None:
        """Remove a user with sessions and keys."""
        call = Call("deleteUser", "DELETE", placed("/users/{name}", name=name))
        await self._sender.send(call, None)

    async def delete_user_access_key(self, name: str, id: str) -> None:
        """Remove an access key of a user, with those made from it."""
        call = Call("deleteUserAccessKey", "DELETE", placed("/users/{name}/access-keys/{id}", name=name, id=id))
        await self._sender.send(call, None)

    async def delete_zone(self, id: str) -> None:
        """Remove a zone (supervisor)."""
        call = Call("deleteZone", "DELETE", placed("/zones/{id}", id=id))
        await self._sender.send(call, None)

    async def disconnect_outlet_client(self, id: str) -> None:
        """Disconnect what is attached (administrator). It may attach again after a minute; taking the passphrase
        away, or disabling the user, is what keeps it out.
        """
        call = Call("disconnectOutletClient", "DELETE", placed("/outlet/clients/{id}", id=id))
        await self._sender.send(call, None)

    async def dismiss_waiting(self, id: str) -> None:
        """Take a vehicle off the list (administrator). It comes again when it is heard."""
        call = Call("dismissWaiting", "DELETE", placed("/waiting/{id}", id=id))
        await self._sender.send(call, None)

    async def download_log(self, id: str, number: int) -> models.CommandView:
        """Fetch a log from the vehicle (operator). The command's progress counts bytes and is streamed; a later
        attempt goes on where one ended.
        """
        call = Call("downloadLog", "POST", placed("/drones/{id}/logs/{number}/download", id=id, number=number))
        return await self._sender.send(call, models.CommandView)

    async def enrol_waiting(self, id: str, body: models.EnrolRequest | None = None) -> models.DroneView:
        """Let a vehicle in as a drone (administrator)."""
        call = Call("enrolWaiting", "POST", placed("/waiting/{id}/enrol", id=id), body=body)
        return await self._sender.send(call, models.DroneView)

    async def export_audit(
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
        call = Call(
            "exportAudit",
            "GET",
            "/audit/file",
            query={
                "user": user,
                "drone": drone,
                "operation": operation,
                "face": face,
                "outcome": outcome,
                "from": from_,
                "until": until,
                "form": form,
            },
        )
        return await self._sender.send(call, bytes)

    async def export_drone_telemetry(
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
        call = Call(
            "exportDroneTelemetry",
            "GET",
            placed("/drones/{id}/telemetry/file", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most, "form": form},
        )
        return await self._sender.send(call, bytes)

    async def export_flight_telemetry(
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
        call = Call(
            "exportFlightTelemetry",
            "GET",
            placed("/flights/{id}/telemetry/file", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most, "form": form},
        )
        return await self._sender.send(call, bytes)

    async def export_logbook(
        self,
        *,
        drone: str | None = None,
        user: str | None = None,
        from_: str | None = None,
        until: str | None = None,
        words: str | None = None,
    ) -> bytes:
        """Take all flights that are looked for along as a table (CSV)."""
        call = Call(
            "exportLogbook",
            "GET",
            "/flights/logbook",
            query={"drone": drone, "user": user, "from": from_, "until": until, "words": words},
        )
        return await self._sender.send(call, bytes)

    async def export_parameters(self, id: str, *, form: str | None = None) -> bytes:
        """Save the parameters as a file. form: list (the default; Mission Planner, MAVProxy) or table
        (QGroundControl).
        """
        call = Call("exportParameters", "GET", placed("/drones/{id}/parameters/file", id=id), query={"form": form})
        return await self._sender.send(call, bytes)

    async def finish_sign_in_elsewhere(self, *, code: str | None = None, state: str | None = None) -> str:
        """Come back from the provider. For browsers; leads to the page."""
        call = Call("finishSignInElsewhere", "GET", "/session/oidc/callback", query={"code": code, "state": state})
        return await self._sender.send(call, str)

    async def follow_events(
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
        call = Call(
            "followEvents", "GET", "/events", query={"after": after, "limit": limit, "drones": drones, "wait": wait}
        )
        return await self._sender.send(call, models.FollowedEvents)

    async def get_audit_receipt(self) -> models.ReceiptView:
        """Get a receipt for all records up to now (supervisor). Kept outside of the server, it shows later whether
        any of them was changed or removed, even by whoever runs the server.
        """
        call = Call("getAuditReceipt", "GET", "/audit/receipt")
        return await self._sender.send(call, models.ReceiptView)

    async def get_command(self, id: str) -> models.CommandView:
        """Look at one command."""
        call = Call("getCommand", "GET", placed("/commands/{id}", id=id))
        return await self._sender.send(call, models.CommandView)

    async def get_control(self, id: str) -> models.ControlView:
        """See who has control."""
        call = Call("getControl", "GET", placed("/drones/{id}/control", id=id))
        return await self._sender.send(call, models.ControlView)

    async def get_dispatch(self, id: str) -> models.DispatchView:
        """Look at one drone that was sent."""
        call = Call("getDispatch", "GET", placed("/dispatches/{id}", id=id))
        return await self._sender.send(call, models.DispatchView)

    async def get_drone(self, id: str) -> models.DroneView:
        """Look at one drone."""
        call = Call("getDrone", "GET", placed("/drones/{id}", id=id))
        return await self._sender.send(call, models.DroneView)

    async def get_drone_telemetry(
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
        call = Call(
            "getDroneTelemetry",
            "GET",
            placed("/drones/{id}/telemetry", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.SeriesView)

    async def get_endpoint(self, id: str) -> models.EndpointView:
        """Look at one endpoint (administrator)."""
        call = Call("getEndpoint", "GET", placed("/endpoints/{id}", id=id))
        return await self._sender.send(call, models.EndpointView)

    async def get_fence(self, id: str) -> models.FenceView:
        """Look at the fence. As last read from the vehicle; null until it first was."""
        call = Call("getFence", "GET", placed("/drones/{id}/fence", id=id))
        return await self._sender.send(call, models.FenceView)

    async def get_flight(self, id: str) -> models.FlightView:
        """Look at one flight."""
        call = Call("getFlight", "GET", placed("/flights/{id}", id=id))
        return await self._sender.send(call, models.FlightView)

    async def get_flight_telemetry(
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
        call = Call(
            "getFlightTelemetry",
            "GET",
            placed("/flights/{id}/telemetry", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.SeriesView)

    async def get_follow(self, id: str) -> models.FollowView:
        """Look at one follow."""
        call = Call("getFollow", "GET", placed("/follows/{id}", id=id))
        return await self._sender.send(call, models.FollowView)

    async def get_health(self) -> models.HealthView:
        """Is the server well? (no sign-in). ready counts the drones that can be armed."""
        call = Call("getHealth", "GET", "/health")
        return await self._sender.send(call, models.HealthView)

    async def get_health_parts(self) -> models.HealthDetails:
        """How each part of the server is, and why it ended last (administrator)."""
        call = Call("getHealthParts", "GET", "/health/parts")
        return await self._sender.send(call, models.HealthDetails)

    async def get_history(self) -> models.HistoryView:
        """Is all that drones do written down? (administrator)."""
        call = Call("getHistory", "GET", "/history")
        return await self._sender.send(call, models.HistoryView)

    async def get_link_security(self, id: str) -> models.LinkSecurityView:
        """Look at how a drone's link is secured, and what was refused."""
        call = Call("getLinkSecurity", "GET", placed("/drones/{id}/link-security", id=id))
        return await self._sender.send(call, models.LinkSecurityView)

    async def get_log_file(self, id: str, number: int) -> bytes:
        """Save a log that was fetched."""
        call = Call("getLogFile", "GET", placed("/drones/{id}/logs/{number}/file", id=id, number=number))
        return await self._sender.send(call, bytes)

    async def get_mission(self, id: str) -> models.SavedMissionView:
        """Look at one saved mission."""
        call = Call("getMission", "GET", placed("/missions/{id}", id=id))
        return await self._sender.send(call, models.SavedMissionView)

    async def get_outlet(self) -> models.OwnOutletView:
        """Where to attach, whether a passphrase is set, and one's own programs that are attached."""
        call = Call("getOutlet", "GET", "/outlet")
        return await self._sender.send(call, models.OwnOutletView)

    async def get_plan(self, id: str) -> models.PlanView:
        """Look at one plan. How far the search is, and once it is finished who flies where and when."""
        call = Call("getPlan", "GET", placed("/plans/{id}", id=id))
        return await self._sender.send(call, models.PlanView)

    async def get_prospects(self, id: str) -> models.WarehouseProspectsView:
        """What would follow if a drone were put into the warehouse (operator). What waits for a drone, the first in
        turn first, and what this one would arm and take off for at once. The same follows when control of a drone
        of the warehouse is given back. Changes nothing.
        """
        call = Call("getProspects", "GET", placed("/warehouse/{id}/prospects", id=id))
        return await self._sender.send(call, models.WarehouseProspectsView)

    async def get_rally_points(self, id: str) -> models.FenceRallyView:
        """Look at the rally points. As last read; null until they first were."""
        call = Call("getRallyPoints", "GET", placed("/drones/{id}/rally-points", id=id))
        return await self._sender.send(call, models.FenceRallyView)

    async def get_recording(self, id: str) -> models.RecordingView:
        """Look at one recording."""
        call = Call("getRecording", "GET", placed("/recordings/{id}", id=id))
        return await self._sender.send(call, models.RecordingView)

    async def get_recording_file(self, id: str) -> bytes:
        """Download a recording. While the flight goes on: all that was heard so far. A tlog, which other programs
        read, or of robots a line of JSON for each message (.jsonl).
        """
        call = Call("getRecordingFile", "GET", placed("/recordings/{id}/file", id=id))
        return await self._sender.send(call, bytes)

    async def get_recording_sent(self, id: str) -> bytes:
        """Download who sent what in a recording (tab-separated). A line for each frame that went to the vehicle: its
        place in the file of the recording (bytes), the command that it was sent for, the epoch of control, and
        the user.
        """
        call = Call("getRecordingSent", "GET", placed("/recordings/{id}/sent", id=id))
        return await self._sender.send(call, bytes)

    async def get_recovery(self, id: str) -> models.RecoveryView:
        """Look at one recovery."""
        call = Call("getRecovery", "GET", placed("/recoveries/{id}", id=id))
        return await self._sender.send(call, models.RecoveryView)

    async def get_registration_policy(self) -> models.RegistrationPolicy:
        """How accounts are made here. approval, invitation or off; needs no sign-in."""
        call = Call("getRegistrationPolicy", "GET", "/registrations")
        return await self._sender.send(call, models.RegistrationPolicy)

    async def get_replay(self, id: str) -> models.ReplayView:
        """Look at one replay."""
        call = Call("getReplay", "GET", placed("/replays/{id}", id=id))
        return await self._sender.send(call, models.ReplayView)

    async def get_run(self, id: str) -> models.RunView:
        """Look at one mission run. How it stands with each waypoint and drone, and what was decided why."""
        call = Call("getRun", "GET", placed("/runs/{id}", id=id))
        return await self._sender.send(call, models.RunView)

    async def get_run_journal(self, id: str, *, from_: int | None = None) -> models.RunJournalView:
        """Read the journal of a mission run (operator). All that befell it and what it decided, up to 200 entries at
        once.
        """
        call = Call("getRunJournal", "GET", placed("/runs/{id}/journal", id=id), query={"from": from_})
        return await self._sender.send(call, models.RunJournalView)

    async def get_sensed(self, id: str) -> models.SensedView:
        """Look at what its sensors brought last. Each kind is counted; the drone in the stream says the newest
        numbers.
        """
        call = Call("getSensed", "GET", placed("/drones/{id}/sensed", id=id))
        return await self._sender.send(call, models.SensedView)

    async def get_sensed_map(self, id: str) -> bytes:
        """Its map, drawn from above. JPEG or PNG; 204 when there was none yet."""
        call = Call("getSensedMap", "GET", placed("/drones/{id}/sensed/map", id=id))
        return await self._sender.send(call, bytes)

    async def get_sensed_picture(self, id: str) -> bytes:
        """The newest picture of its camera. JPEG or PNG; 204 when there was none yet."""
        call = Call("getSensedPicture", "GET", placed("/drones/{id}/sensed/picture", id=id))
        return await self._sender.send(call, bytes)

    async def get_session(self) -> models.SessionView:
        """Who is signed in."""
        call = Call("getSession", "GET", "/session")
        return await self._sender.send(call, models.SessionView)

    async def get_settings(self) -> models.SettingsView:
        """What a client has to know of the server."""
        call = Call("getSettings", "GET", "/settings")
        return await self._sender.send(call, models.SettingsView)

    async def get_traffic(self) -> models.LinkTraffic:
        """What went over the link of each vehicle (administrator)."""
        call = Call("getTraffic", "GET", "/traffic")
        return await self._sender.send(call, models.LinkTraffic)

    async def get_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Look at one virtual drone."""
        call = Call("getVirtualDrone", "GET", placed("/virtual-drones/{id}", id=id))
        return await self._sender.send(call, models.VirtualDroneView)

    async def get_zone(self, id: str) -> models.ZoneFeature:
        """Look at one zone."""
        call = Call("getZone", "GET", placed("/zones/{id}", id=id))
        return await self._sender.send(call, models.ZoneFeature)

    async def give_command(
        self, id: str, body: models.CommandRequest, *, wait: float | None = None
    ) -> models.CommandView:
        """Give a command (operator). 202 with the command under way; with wait: 200 with its outcome if it ends in
        that time. 409 when the drone's state does not allow it, with the sentence why.
        """
        call = Call("giveCommand", "POST", placed("/drones/{id}/commands", id=id), query={"wait": wait}, body=body)
        return await self._sender.send(call, models.CommandView)

    async def give_drone(self, id: str, drone: str, body: models.GiftRequest | None = None) -> models.GiftView:
        """Give a drone of your own organisation to another one. On the ground, disarmed, and out of every operation
        and the warehouse. Only its new owners see it from then on. Flights, recordings, commands and telemetry of
        before stay with those who had it, and go along as well if histories says so, but never with names of
        people. What is on board goes along, and the keys of the vehicle still hold: change them.
        """
        call = Call("giveDrone", "PUT", placed("/organisations/{id}/drones/{drone}", id=id, drone=drone), body=body)
        return await self._sender.send(call, models.GiftView)

    async def give_up_run_drone(self, id: str, drone: str) -> models.RunView:
        """Take a drone out of a mission run (operator). It is called home, and others fly its waypoints."""
        call = Call("giveUpRunDrone", "POST", placed("/runs/{id}/drones/{drone}/give-up", id=id, drone=drone))
        return await self._sender.send(call, models.RunView)

    async def grant_control(self, id: str, body: models.ControlGrantRequest) -> models.ControlView:
        """Give control to somebody who asks for it (holder)."""
        call = Call("grantControl", "POST", placed("/drones/{id}/control/grant", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def hand_over_control(self, id: str, body: models.ControlHandOverRequest) -> models.ControlView:
        """Give control to somebody (holder). They keep it for 30 s, or by using it."""
        call = Call("handOverControl", "POST", placed("/drones/{id}/control/hand-over", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def import_parameters(
        self, id: str, body: bytes, *, dry_run: bool | None = None
    ) -> models.ParametersFileView:
        """Compare with a file, or load it (operator). The body is the file as text/plain, in either form, up to 1
        MB. With dryRun=true nothing is sent; else what differs is changed and read back.
        """
        call = Call(
            "importParameters",
            "POST",
            placed("/drones/{id}/parameters/file", id=id),
            query={"dryRun": dry_run},
            body=body,
            content_type="text/plain",
        )
        return await self._sender.send(call, models.ParametersFileView)

    async def import_zones(
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
        call = Call("importZones", "POST", "/zones/import", body=body, content_type=content_type)
        return await self._sender.send(call, models.ZoneImportView)

    async def install_link_key(
        self, id: str, body: models.LinkSecurityChangeRequest | None = None
    ) -> models.LinkSecurityView:
        """Give the vehicle its key and hear that it signs (administrator). Over a safe link only, unless confirmed.
        202: still under way.
        """
        call = Call("installLinkKey", "POST", placed("/drones/{id}/link-key/install", id=id), body=body)
        return await self._sender.send(call, models.LinkSecurityView)

    async def issue_robot_key(self, body: models.RobotKeyRequest) -> models.RobotKeyView:
        """Issue the key of a robot (administrator). The key is in this answer and never shown again. With "drone" it
        replaces that robot's key, and the one before is void at once.
        """
        call = Call("issueRobotKey", "POST", "/robot-keys", body=body)
        return await self._sender.send(call, models.RobotKeyView)

    async def join_run(self, id: str, body: models.RunJoinRequest) -> models.RunView:
        """Have a further drone join a mission run (operator). One that stands on the ground and that nobody else has
        control of.
        """
        call = Call("joinRun", "POST", placed("/runs/{id}/drones", id=id), body=body)
        return await self._sender.send(call, models.RunView)

    async def keep_control(self, id: str, body: models.ControlHeartbeatRequest) -> models.ControlView:
        """Say that the holder is there (holder). Every 2 s; lost after 6 s without."""
        call = Call("keepControl", "POST", placed("/drones/{id}/control/heartbeat", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def list_access_keys(self) -> models.AccessKeys:
        """List one's own access keys."""
        call = Call("listAccessKeys", "GET", "/access-keys")
        return await self._sender.send(call, models.AccessKeys)

    async def list_commands(self, id: str) -> models.Commands:
        """List a drone's last commands. Newest first, at most 50."""
        call = Call("listCommands", "GET", placed("/drones/{id}/commands", id=id))
        return await self._sender.send(call, models.Commands)

    async def list_dispatches(self) -> models.DispatchList:
        """List drones that were sent. Yours, and those of your organisation whose drones you all see: under way, and
        the newest that are over.
        """
        call = Call("listDispatches", "GET", "/dispatches")
        return await self._sender.send(call, models.DispatchList)

    async def list_drone_events(
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
        call = Call(
            "listDroneEvents",
            "GET",
            placed("/drones/{id}/events", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.Events)

    async def list_drone_telemetry_points(
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
        call = Call(
            "listDroneTelemetryPoints",
            "GET",
            placed("/drones/{id}/telemetry/points", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.Points)

    async def list_drones(self, *, active: bool | None = None) -> models.Drones:
        """List the drones."""
        call = Call("listDrones", "GET", "/drones", query={"active": active})
        return await self._sender.send(call, models.Drones)

    async def list_dtls_keys(self) -> models.DtlsKeys:
        """List the DTLS keys of vehicles (administrator)."""
        call = Call("listDtlsKeys", "GET", "/dtls-keys")
        return await self._sender.send(call, models.DtlsKeys)

    async def list_endpoints(self) -> models.Endpoints:
        """List the endpoints with their state and counters (administrator)."""
        call = Call("listEndpoints", "GET", "/endpoints")
        return await self._sender.send(call, models.Endpoints)

    async def list_fleets(self) -> models.Fleets:
        """List the fleets."""
        call = Call("listFleets", "GET", "/fleets")
        return await self._sender.send(call, models.Fleets)

    async def list_flight_events(
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
        call = Call(
            "listFlightEvents",
            "GET",
            placed("/flights/{id}/events", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.Events)

    async def list_flight_telemetry_points(
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
        call = Call(
            "listFlightTelemetryPoints",
            "GET",
            placed("/flights/{id}/telemetry/points", id=id),
            query={"from": from_, "until": until, "fields": fields, "slots": slots, "most": most},
        )
        return await self._sender.send(call, models.Points)

    async def list_flights(
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
        call = Call(
            "listFlights",
            "GET",
            "/flights",
            query={
                "drone": drone,
                "user": user,
                "from": from_,
                "until": until,
                "words": words,
                "before": before,
                "limit": limit,
            },
        )
        return await self._sender.send(call, models.Flights)

    async def list_follows(self) -> models.FollowList:
        """List follows. Those of your organisation whose drones you see: under way, and the newest that are over."""
        call = Call("listFollows", "GET", "/follows")
        return await self._sender.send(call, models.FollowList)

    async def list_given_drones(self, id: str) -> models.Gifts:
        """List the drones that were given to an organisation and that it still has. As they were called when they
        were given.
        """
        call = Call("listGivenDrones", "GET", placed("/organisations/{id}/drones", id=id))
        return await self._sender.send(call, models.Gifts)

    async def list_grants(self) -> models.Grants:
        """List the grants."""
        call = Call("listGrants", "GET", "/grants")
        return await self._sender.send(call, models.Grants)

    async def list_groups(self) -> models.Groups:
        """List the groups of users."""
        call = Call("listGroups", "GET", "/groups")
        return await self._sender.send(call, models.Groups)

    async def list_invitations(self) -> models.Invitations:
        """List the open invitations."""
        call = Call("listInvitations", "GET", "/invitations")
        return await self._sender.send(call, models.Invitations)

    async def list_left_behind(self) -> models.LeftBehind:
        """List removed drones with what their owners had set (administrator). What the cloud had changed on them was
        not put back before they were removed.
        """
        call = Call("listLeftBehind", "GET", "/left-behind")
        return await self._sender.send(call, models.LeftBehind)

    async def list_logs(self, id: str) -> models.LogsView:
        """List the logs on board. As last listed; null until they first were."""
        call = Call("listLogs", "GET", placed("/drones/{id}/logs", id=id))
        return await self._sender.send(call, models.LogsView)

    async def list_missions(self) -> models.Missions:
        """List the saved missions."""
        call = Call("listMissions", "GET", "/missions")
        return await self._sender.send(call, models.Missions)

    async def list_organisations(self) -> models.Organisations:
        """List the organisations. With how many users and drones each has."""
        call = Call("listOrganisations", "GET", "/organisations")
        return await self._sender.send(call, models.Organisations)

    async def list_outlet_clients(self) -> models.OutletView:
        """List all that is attached, and what was refused (administrator)."""
        call = Call("listOutletClients", "GET", "/outlet/clients")
        return await self._sender.send(call, models.OutletView)

    async def list_parameters(self, id: str, *, search: str | None = None) -> models.ParametersView:
        """List or search the parameters. As last heard from the vehicle; readAt is null until they were first read."""
        call = Call("listParameters", "GET", placed("/drones/{id}/parameters", id=id), query={"search": search})
        return await self._sender.send(call, models.ParametersView)

    async def list_plans(self) -> models.PlanList:
        """List your plans. Without their ways. Forgotten an hour after they ended."""
        call = Call("listPlans", "GET", "/plans")
        return await self._sender.send(call, models.PlanList)

    async def list_recordings(self, *, drone: str | None = None) -> models.RecordingPage:
        """List the recordings, newest first, and the room that they take."""
        call = Call("listRecordings", "GET", "/recordings", query={"drone": drone})
        return await self._sender.send(call, models.RecordingPage)

    async def list_recoveries(self) -> models.RecoveryList:
        """List recoveries. Yours, and those of your organisation whose drones you all see: under way, and the newest
        that are over.
        """
        call = Call("listRecoveries", "GET", "/recoveries")
        return await self._sender.send(call, models.RecoveryList)

    async def list_replays(self) -> models.Replays:
        """List the replays."""
        call = Call("listReplays", "GET", "/replays")
        return await self._sender.send(call, models.Replays)

    async def list_robot_keys(self) -> models.RobotKeys:
        """List the keys of robots (administrator)."""
        call = Call("listRobotKeys", "GET", "/robot-keys")
        return await self._sender.send(call, models.RobotKeys)

    async def list_runs(self) -> models.RunList:
        """List mission runs. Those of your organisation all of whose drones you see: under way, and the newest that
        are over. Forgotten 90 days after their end.
        """
        call = Call("listRuns", "GET", "/runs")
        return await self._sender.send(call, models.RunList)

    async def list_user_access_keys(self, name: str) -> models.AccessKeys:
        """List a user's access keys. What they may do and when they were last used."""
        call = Call("listUserAccessKeys", "GET", placed("/users/{name}/access-keys", name=name))
        return await self._sender.send(call, models.AccessKeys)

    async def list_users(self) -> models.Users:
        """List the users. With those who wait until they are let in."""
        call = Call("listUsers", "GET", "/users")
        return await self._sender.send(call, models.Users)

    async def list_virtual_drones(self) -> models.VirtualDroneList:
        """List your virtual drones. Supervisors see those of all users."""
        call = Call("listVirtualDrones", "GET", "/virtual-drones")
        return await self._sender.send(call, models.VirtualDroneList)

    async def list_waiting(self) -> models.Waitings:
        """List the vehicles that wait (administrator)."""
        call = Call("listWaiting", "GET", "/waiting")
        return await self._sender.send(call, models.Waitings)

    async def list_warehouse(self) -> models.WarehouseView:
        """List the drones of the warehouse. Those that you may see."""
        call = Call("listWarehouse", "GET", "/warehouse")
        return await self._sender.send(call, models.WarehouseView)

    async def list_zones(self) -> models.ZoneCollection:
        """List the zones. A GeoJSON FeatureCollection."""
        call = Call("listZones", "GET", "/zones")
        return await self._sender.send(call, models.ZoneCollection)

    async def make_access_key(self, body: models.KeyRequest) -> models.KeyView:
        """Make an access key. The key itself is in this answer and never shown again. What is left out is as wide as
        you are; made with a key, it stays within that key and goes with it.
        """
        call = Call("makeAccessKey", "POST", "/access-keys", body=body)
        return await self._sender.send(call, models.KeyView)

    async def make_backup(self) -> bytes:
        """Make a backup (administrator). The answer is a zip of all that is stored."""
        call = Call("makeBackup", "POST", "/backup")
        return await self._sender.send(call, bytes)

    async def make_dtls_key(self, body: models.DtlsKeyRequest) -> models.DtlsKeyView:
        """Make the DTLS key of a vehicle (administrator). The secret is in this answer and never shown again; a
        drone's key before is void.
        """
        call = Call("makeDtlsKey", "POST", "/dtls-keys", body=body)
        return await self._sender.send(call, models.DtlsKeyView)

    async def make_link_key(self, id: str, body: models.LinkKeyRequest) -> models.MadeLinkKey:
        """Make a key, or bring one along (administrator). The key is in this answer and never shown again; it is not
        on the vehicle yet.
        """
        call = Call("makeLinkKey", "POST", placed("/drones/{id}/link-key", id=id), body=body)
        return await self._sender.send(call, models.MadeLinkKey)

    async def make_plan(self, body: models.PlanRequest) -> models.PlanView:
        """Ask for a plan (planner). Answered at once; look at it until it is finished, or hear of it on the stream.
        Where drones are, their homes, batteries, links and kinds are those that the cloud knows now: whatever is
        not known is said. 503 when too many wait already.
        """
        call = Call("makePlan", "POST", "/plans", body=body)
        return await self._sender.send(call, models.PlanView)

    async def make_stream_ticket(self) -> models.StreamTicket:
        """Get a ticket for the stream. Good for one connection within 30 s."""
        call = Call("makeStreamTicket", "POST", "/stream-tickets")
        return await self._sender.send(call, models.StreamTicket)

    async def move_run_waypoint(self, id: str, waypoint: str, body: models.RunMoveRequest) -> models.RunView:
        """Move a waypoint of a mission run (operator). What is left out of latitude, longitude and altitude stays;
        one of them is needed.
        """
        call = Call(
            "moveRunWaypoint", "PATCH", placed("/runs/{id}/waypoints/{waypoint}", id=id, waypoint=waypoint), body=body
        )
        return await self._sender.send(call, models.RunView)

    async def open_follow(self, body: models.FollowOpenRequest) -> models.FollowView:
        """Ask to be followed (operator). Chooses the drone of the warehouse that is nearest and has enough in its
        battery, or takes the one that is named, and keeps it. 409 with why each cannot, when none can.
        """
        call = Call("openFollow", "POST", "/follows", body=body)
        return await self._sender.send(call, models.FollowView)

    async def open_outlet_port(self, body: models.OutletPortRequest) -> models.OutletPortView:
        """Open a personal port, view-only, for a program that cannot sign. The first to speak there from that
        address or network has it, until it is closed, its hours are over or the server is restarted. It shows
        unsigned what you may see; nothing sent there changes anything.
        """
        call = Call("openOutletPort", "POST", "/outlet/ports", body=body)
        return await self._sender.send(call, models.OutletPortView)

    async def order_tour(self, body: models.TourRequest) -> models.TourView:
        """Put the waypoints of one drone into a good order (planner). From where the drone is, round the zones that
        bind it; nothing is sent to it. Answered after the seconds of the search, at once where there are few
        waypoints. 409 while another one of yours is under way; 503 when too many wait already.
        """
        call = Call("orderTour", "POST", "/tours", body=body)
        return await self._sender.send(call, models.TourView)

    async def pause_follow(self, id: str) -> models.FollowView:
        """Pause a follow (operator). The drone stays where it is, in the air. 409 when it does not follow."""
        call = Call("pauseFollow", "POST", placed("/follows/{id}/pause", id=id))
        return await self._sender.send(call, models.FollowView)

    async def pause_run(self, id: str) -> models.RunView:
        """Pause a mission run (operator). Its drones in the air hold where they are, those on the ground stay there;
        who is on its way home, or has nothing left to visit, comes down. 409 when it is paused already.
        """
        call = Call("pauseRun", "POST", placed("/runs/{id}/pause", id=id))
        return await self._sender.send(call, models.RunView)

    async def preview_recovery(self, body: models.RecoveryRequest) -> models.RecoveryPreview:
        """Preview a recovery (operator). What the same request would do if it were begun now: which drones come, at
        which height, in which order, and where each comes down; and which are left alone, with the reason.
        Nothing is commanded. 409 when they do not fit, with the number that does.
        """
        call = Call("previewRecovery", "POST", "/recoveries/preview", body=body)
        return await self._sender.send(call, models.RecoveryPreview)

    async def put_into_warehouse(self, id: str) -> models.WarehouseView:
        """Let a drone serve virtual ones (supervisor)."""
        call = Call("putIntoWarehouse", "PUT", placed("/warehouse/{id}", id=id))
        return await self._sender.send(call, models.WarehouseView)

    async def read_fence(self, id: str) -> models.CommandView:
        """Read the fence from the vehicle (operator)."""
        call = Call("readFence", "POST", placed("/drones/{id}/fence/refresh", id=id))
        return await self._sender.send(call, models.CommandView)

    async def read_logs(self, id: str) -> models.CommandView:
        """Ask the vehicle for the list of its logs (operator)."""
        call = Call("readLogs", "POST", placed("/drones/{id}/logs/refresh", id=id))
        return await self._sender.send(call, models.CommandView)

    async def read_parameters(self, id: str, *, wait: float | None = None) -> models.CommandView:
        """Read all parameters from the vehicle (operator). Its progress is streamed."""
        call = Call("readParameters", "POST", placed("/drones/{id}/parameters/refresh", id=id), query={"wait": wait})
        return await self._sender.send(call, models.CommandView)

    async def read_rally_points(self, id: str) -> models.CommandView:
        """Read the rally points from the vehicle (operator)."""
        call = Call("readRallyPoints", "POST", placed("/drones/{id}/rally-points/refresh", id=id))
        return await self._sender.send(call, models.CommandView)

    async def refuse_control(self, id: str, body: models.ControlRefuseRequest) -> models.ControlView:
        """Keep control from somebody who asks for it (holder)."""
        call = Call("refuseControl", "POST", placed("/drones/{id}/control/refuse", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def register(self, body: models.RegistrationRequest) -> models.RegistrationAnswer:
        """Ask for an account. Needs no sign-in. 201: with an invitation, sign in now. 202: an administrator decides.
        At most ten from one address in ten minutes.
        """
        call = Call("register", "POST", "/registrations", body=body)
        return await self._sender.send(call, models.RegistrationAnswer)

    async def release_control(self, id: str) -> models.ControlView:
        """Give control back (holder)."""
        call = Call("releaseControl", "DELETE", placed("/drones/{id}/control", id=id))
        return await self._sender.send(call, models.ControlView)

    async def remove_drone(self, id: str) -> None:
        """Forget a lost drone (administrator)."""
        call = Call("removeDrone", "DELETE", placed("/drones/{id}", id=id))
        await self._sender.send(call, None)

    async def remove_endpoint(self, id: str) -> None:
        """Remove an endpoint that was added (administrator)."""
        call = Call("removeEndpoint", "DELETE", placed("/endpoints/{id}", id=id))
        await self._sender.send(call, None)

    async def remove_plan(self, id: str) -> None:
        """Cancel or forget a plan (planner). Cancels one that is queued or running; forgets one that has ended."""
        call = Call("removePlan", "DELETE", placed("/plans/{id}", id=id))
        await self._sender.send(call, None)

    async def remove_replay(self, id: str) -> None:
        """End a replay and remove its drones (operator)."""
        call = Call("removeReplay", "DELETE", placed("/replays/{id}", id=id))
        await self._sender.send(call, None)

    async def remove_virtual_drone(self, id: str) -> None:
        """Remove a virtual drone (planner). Only while its mission is not under way."""
        call = Call("removeVirtualDrone", "DELETE", placed("/virtual-drones/{id}", id=id))
        await self._sender.send(call, None)

    async def rename_drone(self, id: str, body: models.RenameRequest) -> models.DroneView:
        """Give a drone another name (operator)."""
        call = Call("renameDrone", "PATCH", placed("/drones/{id}", id=id), body=body)
        return await self._sender.send(call, models.DroneView)

    async def rename_organisation(self, id: str, body: models.OrganisationNameRequest) -> models.OrganisationView:
        """Rename an organisation."""
        call = Call("renameOrganisation", "PATCH", placed("/organisations/{id}", id=id), body=body)
        return await self._sender.send(call, models.OrganisationView)

    async def renew_access_key(self, id: str) -> models.KeyView:
        """Renew an access key. The same key with a new secret, which is in this answer and never shown again; the
        old one is void at once. Keys made from it stay.
        """
        call = Call("renewAccessKey", "POST", placed("/access-keys/{id}/renew", id=id))
        return await self._sender.send(call, models.KeyView)

    async def replace_fleet(self, id: str, body: models.FleetRequest) -> models.FleetView:
        """Change the name and the drones of a fleet."""
        call = Call("replaceFleet", "PUT", placed("/fleets/{id}", id=id), body=body)
        return await self._sender.send(call, models.FleetView)

    async def replace_group(self, id: str, body: models.GroupRequest) -> models.GroupView:
        """Change the name and the members of a group."""
        call = Call("replaceGroup", "PUT", placed("/groups/{id}", id=id), body=body)
        return await self._sender.send(call, models.GroupView)

    async def replace_mission(self, id: str, body: models.MissionRequest) -> models.SavedMissionView:
        """Replace a saved mission (operator)."""
        call = Call("replaceMission", "PUT", placed("/missions/{id}", id=id), body=body)
        return await self._sender.send(call, models.SavedMissionView)

    async def replace_virtual_drone(self, id: str, body: models.VirtualDroneRequest) -> models.VirtualDroneView:
        """Name it, say what it needs, plan its mission (planner). Holds from the next start on. No drone needs to be
        there.
        """
        call = Call("replaceVirtualDrone", "PUT", placed("/virtual-drones/{id}", id=id), body=body)
        return await self._sender.send(call, models.VirtualDroneView)

    async def replace_zone(self, id: str, body: models.ZoneFeature) -> models.ZoneFeature:
        """Replace a zone (supervisor). Binds at once, drones in flight too."""
        call = Call("replaceZone", "PUT", placed("/zones/{id}", id=id), body=body)
        return await self._sender.send(call, models.ZoneFeature)

    async def replay_recording(self, id: str, *, speed: float | None = None) -> models.ReplayView:
        """Play a recording on the map (operator)."""
        call = Call("replayRecording", "POST", placed("/recordings/{id}/replays", id=id), query={"speed": speed})
        return await self._sender.send(call, models.ReplayView)

    async def replay_run_journal(self, id: str) -> models.RunReplayView:
        """Replay the journal of a mission run (operator). Decides once more on all that befell it, and tells the
        first decision that differs by a letter.
        """
        call = Call("replayRunJournal", "GET", placed("/runs/{id}/journal/replay", id=id))
        return await self._sender.send(call, models.RunReplayView)

    async def report_follow_positions(self, id: str, body: models.FollowPositionsRequest) -> models.FollowReceipt:
        """Say where the phone is (operator). Once a second or so. What was said before may be said again: it counts
        once. Only the user who asked to be followed says that. 409 when the follow is over.
        """
        call = Call("reportFollowPositions", "POST", placed("/follows/{id}/positions", id=id), body=body)
        return await self._sender.send(call, models.FollowReceipt)

    async def request_control(self, id: str, body: models.ControlAskRequest | None = None) -> models.ControlView:
        """Ask the holder for control (operator). 202 while the holder decides, for up to a minute; 200 where control
        was free.
        """
        call = Call("requestControl", "POST", placed("/drones/{id}/control/request", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def reset_password(self, name: str) -> models.OneTimePassword:
        """Give a user a one-time password. It is in this answer and never shown again; it serves until the user has
        taken another one.
        """
        call = Call("resetPassword", "POST", placed("/users/{name}/password", name=name))
        return await self._sender.send(call, models.OneTimePassword)

    async def resume_run_drone(self, id: str, drone: str) -> models.RunView:
        """Give a drone back to its mission run (operator). One that a pilot or somebody else took. Nothing else
        gives control back to the run.
        """
        call = Call("resumeRunDrone", "POST", placed("/runs/{id}/drones/{drone}/resume", id=id, drone=drone))
        return await self._sender.send(call, models.RunView)

    async def resume_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Go on with what is not flown yet (operator). After somebody who goes first took the drone, or drone after
        drone could not go on. Of several shares all go on that wait for it.
        """
        call = Call("resumeVirtualDrone", "POST", placed("/virtual-drones/{id}/resume", id=id))
        return await self._sender.send(call, models.VirtualDroneView)

    async def revoke_grant(self, id: str) -> None:
        """Take a grant back. At once, on open streams too."""
        call = Call("revokeGrant", "DELETE", placed("/grants/{id}", id=id))
        await self._sender.send(call, None)

    async def revoke_robot_key(self, id: str) -> None:
        """Revoke the key of a robot (administrator). Its links end at once. Its drone stays, with all that is known
        of it.
        """
        call = Call("revokeRobotKey", "DELETE", placed("/robot-keys/{id}", id=id))
        await self._sender.send(call, None)

    async def rotate_link_key(
        self, id: str, body: models.LinkSecurityChangeRequest | None = None
    ) -> models.LinkSecurityView:
        """Change the vehicle over to a new key (administrator). Both keys are accepted meanwhile; on failure the old
        one stays. 202: still under way.
        """
        call = Call("rotateLinkKey", "POST", placed("/drones/{id}/link-key/rotate", id=id), body=body)
        return await self._sender.send(call, models.LinkSecurityView)

    async def search_audit(
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
        call = Call(
            "searchAudit",
            "GET",
            "/audit",
            query={
                "user": user,
                "drone": drone,
                "operation": operation,
                "face": face,
                "outcome": outcome,
                "from": from_,
                "until": until,
                "before": before,
                "limit": limit,
            },
        )
        return await self._sender.send(call, models.AuditPage)

    async def send_drone(self, body: models.DispatchRequest) -> models.DispatchView:
        """Send a drone here (operator). Of the drones of the pool that you may command, the nearest that can come is
        chosen: it is free, zones let it go there and back, its battery lasts with a reserve, its link is good,
        and it can hover. It starts at once. When it is there, you have control of it, as if you had taken it:
        give signs of life from then on, within 20 s, or it holds and flies home. 409 with why each cannot, when
        none can.
        """
        call = Call("sendDrone", "POST", "/dispatches", body=body)
        return await self._sender.send(call, models.DispatchView)

    async def set_fence(self, id: str, body: models.FenceView) -> models.CommandView:
        """Replace the fence (operator). Up to 500 polygons and circles with together 2000 corners, and a return
        point; how many of them a vehicle takes is its own. What was read with something left out is refused.
        """
        call = Call("setFence", "PUT", placed("/drones/{id}/fence", id=id), body=body)
        return await self._sender.send(call, models.CommandView)

    async def set_fence_from_zones(self, id: str) -> models.CommandView:
        """Make the cloud's zones the vehicle's own fence (planner). All zones without floor and ceiling that bind
        this drone now, whoever flies it; they then hold also where the vehicle does not hear the cloud. Zones
        that a vehicle cannot keep are named among the warnings. What was its fence before is replaced.
        """
        call = Call("setFenceFromZones", "PUT", placed("/drones/{id}/fence/zones", id=id))
        return await self._sender.send(call, models.CommandView)

    async def set_group_only_granted(self, id: str, body: models.OnlyGrantedRequest) -> None:
        """Let the members of a group see only what was granted, or all drones by their role."""
        call = Call("setGroupOnlyGranted", "PUT", placed("/groups/{id}/only-granted", id=id), body=body)
        await self._sender.send(call, None)

    async def set_link_security(self, id: str, body: models.LinkSecurityPolicyRequest) -> models.LinkSecurityView:
        """Set the policy: off, optional or required (administrator)."""
        call = Call("setLinkSecurity", "PUT", placed("/drones/{id}/link-security", id=id), body=body)
        return await self._sender.send(call, models.LinkSecurityView)

    async def set_outlet_passphrase(self, body: models.PassphraseRequest) -> models.PassphraseView:
        """Set one's own signing passphrase. Without one given it is made up. It is in this answer and never shown
        again; programs that use the one before are disconnected.
        """
        call = Call("setOutletPassphrase", "PUT", "/outlet/passphrase", body=body)
        return await self._sender.send(call, models.PassphraseView)

    async def set_parameter(
        self, id: str, name: str, body: models.ParameterValueRequest, *, wait: float | None = None
    ) -> models.CommandView:
        """Change a parameter (operator). It is read back: when the vehicle holds something else, the command fails
        and says what.
        """
        call = Call(
            "setParameter",
            "PUT",
            placed("/drones/{id}/parameters/{name}", id=id, name=name),
            query={"wait": wait},
            body=body,
        )
        return await self._sender.send(call, models.CommandView)

    async def set_rally_points(self, id: str, body: models.FenceRallyView) -> models.CommandView:
        """Replace the rally points (operator). Up to 250, each with what its altitude is measured from. What was
        read with something left out is refused.
        """
        call = Call("setRallyPoints", "PUT", placed("/drones/{id}/rally-points", id=id), body=body)
        return await self._sender.send(call, models.CommandView)

    async def set_user_only_granted(self, name: str, body: models.OnlyGrantedRequest) -> None:
        """Let a user see only what was granted, or all drones by the role."""
        call = Call("setUserOnlyGranted", "PUT", placed("/users/{name}/only-granted", name=name), body=body)
        await self._sender.send(call, None)

    async def sign_in(self, body: models.Credentials) -> models.SessionView:
        """Sign in. After five wrong passwords in a row: 429 for 30 s."""
        call = Call("signIn", "POST", "/session", body=body)
        return await self._sender.send(call, models.SessionView)

    async def sign_out(self) -> None:
        """Sign out. Ends this session, and the streams that were opened with it."""
        call = Call("signOut", "DELETE", "/session")
        await self._sender.send(call, None)

    async def sign_out_everywhere(self) -> None:
        """Sign out everywhere. Ends all one's own sessions, this one too, and their open streams; access keys stay."""
        call = Call("signOutEverywhere", "POST", "/session/sign-out-everywhere")
        await self._sender.send(call, None)

    async def sign_out_user(self, name: str) -> None:
        """End all sessions of a user. Access keys stay; see those."""
        call = Call("signOutUser", "POST", placed("/users/{name}/sign-out", name=name))
        await self._sender.send(call, None)

    async def start_follow(self, id: str) -> models.FollowView:
        """Start following (operator). The drone takes off and comes. 409 when it was started already."""
        call = Call("startFollow", "POST", placed("/follows/{id}/start", id=id))
        return await self._sender.send(call, models.FollowView)

    async def start_replay(
        self, body: bytes, *, speed: float | None = None, name: str | None = None
    ) -> models.ReplayView:
        """Play a recording (operator). The body is the tlog, up to 512 MB, as application/octet-stream."""
        call = Call(
            "startReplay",
            "POST",
            "/replays",
            query={"speed": speed, "name": name},
            body=body,
            content_type="application/octet-stream",
        )
        return await self._sender.send(call, models.ReplayView)

    async def start_run(self, body: models.RunStartRequest) -> models.RunView:
        """Fly a plan (operator). Takes control of the plan's drones, brings them their missions, starts them and
        conducts them to the end. 409 when the plan must not be flown, or somebody has control of one of its
        drones.
        """
        call = Call("startRun", "POST", "/runs", body=body)
        return await self._sender.send(call, models.RunView)

    async def start_sign_in_elsewhere(self) -> str:
        """Go to the provider to sign in. For browsers; 404 when there is none."""
        call = Call("startSignInElsewhere", "GET", "/session/oidc")
        return await self._sender.send(call, str)

    async def start_virtual_drone(
        self, id: str, body: models.VirtualDroneStartRequest | None = None
    ) -> models.VirtualDroneView:
        """Have its mission flown (operator). By the best drone that is free, or by several where they may share it;
        else it waits, and its place in the queue is told.
        """
        call = Call("startVirtualDrone", "POST", placed("/virtual-drones/{id}/start", id=id), body=body)
        return await self._sender.send(call, models.VirtualDroneView)

    async def stop_follow(self, id: str) -> models.FollowView:
        """Stop a follow (operator). The drone flies home; it is over when it is down."""
        call = Call("stopFollow", "POST", placed("/follows/{id}/stop", id=id))
        return await self._sender.send(call, models.FollowView)

    async def stop_plan(self, id: str) -> models.PlanView:
        """Stop the start of a plan (operator). Drones that have not been started yet are not started, and disarmed
        where they were armed for it. Drones that fly, fly on: call them back by their own commands. 409 when
        nothing is under way.
        """
        call = Call("stopPlan", "POST", placed("/plans/{id}/stop", id=id))
        return await self._sender.send(call, models.PlanView)

    async def stop_run(self, id: str) -> models.RunView:
        """Stop a mission run (operator). Its drones return; it is over when all are down."""
        call = Call("stopRun", "POST", placed("/runs/{id}/stop", id=id))
        return await self._sender.send(call, models.RunView)

    async def stop_virtual_drone(self, id: str) -> models.VirtualDroneView:
        """Stop its mission (operator; supervisors any). All drones that serve it come home."""
        call = Call("stopVirtualDrone", "POST", placed("/virtual-drones/{id}/stop", id=id))
        return await self._sender.send(call, models.VirtualDroneView)

    async def take_back_drone(self, id: str, drone: str) -> models.GiftView:
        """Take a drone back that was given to an organisation. On the ground, disarmed, and out of every operation
        and the warehouse. What it did meanwhile is shown to those who had it then, alone.
        """
        call = Call("takeBackDrone", "DELETE", placed("/organisations/{id}/drones/{drone}", id=id, drone=drone))
        return await self._sender.send(call, models.GiftView)

    async def take_control(self, id: str) -> models.ControlView:
        """Take control where nobody has it (operator). Also back from the pilot at the vehicle. Send the heartbeat
        every 2 s from then on.
        """
        call = Call("takeControl", "POST", placed("/drones/{id}/control/take", id=id))
        return await self._sender.send(call, models.ControlView)

    async def take_from_warehouse(self, id: str) -> None:
        """Let a drone serve virtual ones no more (supervisor). What it serves now it serves to the end."""
        call = Call("takeFromWarehouse", "DELETE", placed("/warehouse/{id}", id=id))
        await self._sender.send(call, None)

    async def take_over_control(self, id: str, body: models.ControlTakeOverRequest) -> models.ControlView:
        """Take control from whoever has it, with a reason (supervisor)."""
        call = Call("takeOverControl", "POST", placed("/drones/{id}/control/take-over", id=id), body=body)
        return await self._sender.send(call, models.ControlView)

    async def verify_audit(self, body: models.ReceiptView | None = None) -> models.AuditVerdictView:
        """Verify all records, against a receipt too if one is sent (administrator). Names the first record that is
        not as it was.
        """
        call = Call("verifyAudit", "POST", "/audit/verification", body=body)
        return await self._sender.send(call, models.AuditVerdictView)

    async def withdraw_invitation(self, id: str) -> None:
        """Withdraw an invitation."""
        call = Call("withdrawInvitation", "DELETE", placed("/invitations/{id}", id=id))
        await self._sender.send(call, None)
