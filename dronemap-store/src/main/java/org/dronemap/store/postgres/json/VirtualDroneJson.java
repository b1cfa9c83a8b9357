package org.dronemap.store.postgres.json;

import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.core.virtual.DroneChoice;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.RequiredArea;
import org.dronemap.core.virtual.SelectionCriterion;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualPlan;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunOrder;
import org.dronemap.core.virtual.VirtualRunStage;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts virtual drones to JSON and back, for the database, so that renamed code never changes stored data. */
public final class VirtualDroneJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private VirtualDroneJson() {}

    public static String write(VirtualDrone drone) {
        ObjectNode to = MAPPER.createObjectNode();
        to.put("id", drone.id().value());
        to.put("name", drone.name());
        to.put("owner", drone.owner());
        to.put("account", drone.account());
        to.put("organisation", drone.organisation().value());
        needs(drone.needs(), to.putObject("needs"));
        mission(drone.mission(), to);
        to.put("upTo", drone.plan().upTo());
        ArrayNode runs = to.putArray("runs");
        drone.runs().forEach(run -> run(run, runs.addObject()));
        ArrayNode recalled = to.putArray("recalled");
        drone.recalled().forEach(id -> recalled.add(id.value()));
        to.put("createdAt", drone.createdAt().toString());
        return MAPPER.writeValueAsString(to);
    }

    public static VirtualDrone read(String json) {
        try {
            JsonNode from = MAPPER.readTree(json);
            return new VirtualDrone(
                    new VirtualDroneId(text(from, "id")),
                    text(from, "name"),
                    text(from, "owner"),
                    // Of before there were ids, when names were what accounts were known by.
                    text(from, from.has("account") ? "account" : "owner"),
                    new OrganisationId(text(from, "organisation")),
                    new VirtualPlan(
                            needs(from.required("needs")), from.has("mission") ? mission(from) : null, upTo(from)),
                    runs(from),
                    drones(from.required("recalled")),
                    moment(from, "createdAt"));
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("A stored virtual drone cannot be read: " + e.getMessage(), e);
        }
    }

    private static void needs(DroneRequirements needs, ObjectNode to) {
        VehicleKind kind = needs.kind();
        to.put("kind", kind == null ? null : StoredNames.of(kind));
        ArrayNode capabilities = to.putArray("capabilities");
        needs.capabilities().stream().map(StoredNames::of).sorted().forEach(capabilities::add);
        to.put("enduranceMinutes", needs.enduranceMinutes());
        RequiredArea area = needs.area();
        if (area != null) {
            ObjectNode circle = to.putObject("area");
            circle.put("latitudeDegrees", area.center().latitudeDegrees());
            circle.put("longitudeDegrees", area.center().longitudeDegrees());
            circle.put("radiusMeters", area.radiusMeters());
        }
    }

    private static DroneRequirements needs(JsonNode from) {
        Set<Capability> capabilities = EnumSet.noneOf(Capability.class);
        from.required("capabilities")
                .forEach(name -> capabilities.add(StoredNames.constant(Capability.class, name.stringValue())));
        return new DroneRequirements(
                from.hasNonNull("kind") ? StoredNames.constant(VehicleKind.class, text(from, "kind")) : null,
                capabilities,
                from.hasNonNull("enduranceMinutes")
                        ? Integer.valueOf(from.required("enduranceMinutes").intValue())
                        : null,
                from.has("area") ? area(from.required("area")) : null);
    }

    private static RequiredArea area(JsonNode from) {
        return new RequiredArea(
                new Geodetic(
                        from.required("latitudeDegrees").doubleValue(),
                        from.required("longitudeDegrees").doubleValue()),
                from.required("radiusMeters").doubleValue());
    }

    private static void mission(@Nullable Mission mission, ObjectNode to) {
        if (mission != null) {
            to.set("mission", MAPPER.readTree(MissionItemJson.write(mission.items())));
        }
    }

    private static Mission mission(JsonNode from) {
        return new Mission(MissionItemJson.read(from.required("mission").toString()));
    }

    /** Of before several drones shared a mission, one flew it. */
    private static int upTo(JsonNode from) {
        return from.has("upTo") ? from.required("upTo").intValue() : 1;
    }

    /** Of before several drones shared a mission, there was one run at most. */
    private static List<VirtualRun> runs(JsonNode from) {
        List<VirtualRun> runs = new ArrayList<>();
        if (from.has("run")) {
            runs.add(run(from.required("run")));
        }
        from.path("runs").forEach(run -> runs.add(run(run)));
        return runs;
    }

    private static void run(VirtualRun run, ObjectNode to) {
        to.put("ticket", run.ticket());
        mission(run.mission(), to);
        to.put("onCloudLoss", StoredNames.of(run.onCloudLoss()));
        to.put("upTo", run.order().upTo());
        to.put("flown", run.flown());
        to.put("stage", StoredNames.of(run.stage()));
        VirtualRunAssignment assignment = run.assignment();
        if (assignment != null) {
            assignment(assignment, to.putObject("assignment"));
        }
        ObjectNode avoided = to.putObject("avoided");
        run.avoided().forEach((drone, until) -> avoided.put(drone.value(), until.toString()));
        to.put("failures", run.failures());
        to.put("note", run.note());
        to.put("detail", run.detail());
        to.put("changedAt", run.changedAt().toString());
    }

    private static VirtualRun run(JsonNode from) {
        Map<DroneId, Instant> avoided = new LinkedHashMap<>();
        from.required("avoided")
                .properties()
                .forEach(entry -> avoided.put(
                        new DroneId(entry.getKey()),
                        Instant.parse(entry.getValue().stringValue())));
        return new VirtualRun(
                new VirtualRunOrder(
                        from.required("ticket").longValue(),
                        mission(from),
                        StoredNames.constant(MissionCloudLossPolicy.class, text(from, "onCloudLoss")),
                        upTo(from)),
                from.required("flown").intValue(),
                StoredNames.constant(VirtualRunStage.class, text(from, "stage")),
                from.has("assignment") ? assignment(from.required("assignment")) : null,
                avoided,
                from.required("failures").intValue(),
                text(from, "note"),
                textOrNull(from, "detail"),
                moment(from, "changedAt"));
    }

    private static void assignment(VirtualRunAssignment assignment, ObjectNode to) {
        choice(assignment.choice(), to.putObject("choice"));
        to.put("first", assignment.first());
        to.put("takeOffMeters", assignment.takeOffMeters());
        CommandId command = assignment.command();
        to.put("command", command == null ? null : command.value());
        to.put("tries", assignment.tries());
        to.put("changedAt", assignment.changedAt().toString());
    }

    private static VirtualRunAssignment assignment(JsonNode from) {
        return new VirtualRunAssignment(
                choice(from.required("choice")),
                from.required("first").intValue(),
                from.hasNonNull("takeOffMeters")
                        ? Double.valueOf(from.required("takeOffMeters").doubleValue())
                        : null,
                from.hasNonNull("command") ? new CommandId(text(from, "command")) : null,
                from.required("tries").intValue(),
                moment(from, "changedAt"));
    }

    private static void choice(DroneChoice choice, ObjectNode to) {
        DroneId runnerUp = choice.runnerUp();
        SelectionCriterion deciding = choice.deciding();
        to.put("chosen", choice.chosen().value());
        to.put("runnerUp", runnerUp == null ? null : runnerUp.value());
        to.put("deciding", deciding == null ? null : StoredNames.of(deciding));
        to.put("chosenValue", choice.chosenValue());
        to.put("otherValue", choice.otherValue());
        to.put("energy", choice.energy());
        ArrayNode unfit = to.putArray("unfit");
        choice.unfit()
                .forEach(one ->
                        unfit.addObject().put("drone", one.drone().value()).put("why", one.why()));
    }

    private static DroneChoice choice(JsonNode from) {
        List<DroneChoice.Unfit> unfit = new ArrayList<>();
        from.required("unfit")
                .forEach(one -> unfit.add(new DroneChoice.Unfit(new DroneId(text(one, "drone")), text(one, "why"))));
        return new DroneChoice(
                new DroneId(text(from, "chosen")),
                from.hasNonNull("runnerUp") ? new DroneId(text(from, "runnerUp")) : null,
                from.hasNonNull("deciding")
                        ? StoredNames.constant(SelectionCriterion.class, text(from, "deciding"))
                        : null,
                from.required("chosenValue").doubleValue(),
                from.required("otherValue").doubleValue(),
                text(from, "energy"),
                unfit);
    }

    private static List<DroneId> drones(JsonNode from) {
        List<DroneId> drones = new ArrayList<>();
        from.forEach(id -> drones.add(new DroneId(id.stringValue())));
        return drones;
    }

    private static String text(JsonNode from, String field) {
        return from.required(field).stringValue();
    }

    private static @Nullable String textOrNull(JsonNode from, String field) {
        return from.hasNonNull(field) ? text(from, field) : null;
    }

    private static Instant moment(JsonNode from, String field) {
        return Instant.parse(text(from, field));
    }
}
