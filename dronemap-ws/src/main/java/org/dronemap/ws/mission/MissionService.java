package org.dronemap.ws.mission;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.mission.SavedMission;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Saves, lists, changes and deletes missions in the server's mission library, for users. Any thread. */
final class MissionService {
    static final int LONGEST_NAME = 80;

    private final MissionStore store;
    private final Clock clock;

    /** A mission as a client writes it. */
    @Schema(name = "MissionRequest")
    record MissionRequest(
            @Size(min = 1, max = MissionService.LONGEST_NAME) @Nullable
            String name,

            @Size(min = 1, max = Mission.MAX_ITEMS) @Nullable
            List<MissionItemRequest> items) {}

    /** A saved mission as clients see it. */
    @Schema(name = "SavedMissionView")
    record SavedMissionView(String id, String name, List<MissionItemView> items, String by, Instant changedAt) {
        static SavedMissionView of(SavedMission saved) {
            return new SavedMissionView(
                    saved.id(),
                    saved.name(),
                    MissionItemView.of(saved.mission().items()),
                    saved.changedBy(),
                    saved.changedAt().truncatedTo(ChronoUnit.MILLIS));
        }
    }

    MissionService(MissionStore store, Clock clock) {
        this.store = store;
        this.clock = clock;
    }

    List<SavedMissionView> missions(Principal principal) {
        return store.missions().stream()
                .filter(saved -> saved.organisation().equals(principal.organisation()))
                .map(SavedMissionView::of)
                .toList();
    }

    SavedMissionView mission(Principal principal, String id) {
        return SavedMissionView.of(find(principal, id));
    }

    SavedMissionView add(Principal principal, MissionRequest request) {
        return save(principal, UUID.randomUUID().toString(), request);
    }

    SavedMissionView replace(Principal principal, String id, MissionRequest request) {
        RoleChecks.require(principal, Role.PLANNER);
        return save(principal, find(principal, id).id(), request);
    }

    void delete(Principal principal, String id) {
        RoleChecks.require(principal, Role.PLANNER);
        if (!store.delete(find(principal, id).id())) {
            throw Rejection.unknown(NotFoundProblem.MISSION, id);
        }
    }

    private SavedMissionView save(Principal principal, String id, MissionRequest request) {
        RoleChecks.require(principal, Role.PLANNER);
        SavedMission saved = new SavedMission(
                id,
                NameRules.checked("name", request.name(), LONGEST_NAME),
                MissionReader.read(request.items()),
                principal.name(),
                clock.instant(),
                principal.organisation());
        store.save(saved);
        return SavedMissionView.of(saved);
    }

    private SavedMission find(Principal principal, String id) {
        return store.mission(id)
                .filter(saved -> saved.organisation().equals(principal.organisation()))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.MISSION, id));
    }
}
