package org.dronemap.ws.wiring;

import java.nio.file.Path;
import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.conduct.TakeOffClearance;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.outlet.rights.PortRange;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.store.Stores;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.BroadcastService;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.dispatch.DispatchScheduler;
import org.dronemap.ws.dispatch.DispatchService;
import org.dronemap.ws.drone.DronePlaceNames;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.fence.FenceService;
import org.dronemap.ws.follow.FollowReliefScheduler;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.log.OnboardLogArchive;
import org.dronemap.ws.log.OnboardLogService;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.parameter.ParameterService;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.plan.PoolPlanDrones;
import org.dronemap.ws.recovery.RecoveryService;
import org.dronemap.ws.run.RunJournalService;
import org.dronemap.ws.run.RunPoolScheduler;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.run.RunZoneSynchronizer;
import org.dronemap.ws.server.OperationComponents;
import org.dronemap.ws.server.ServerBuilder;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.server.ShutdownSequence;
import org.dronemap.ws.settings.OutletSettings;
import org.dronemap.ws.settings.RobotSettings;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.user.RegistrationPolicy;
import org.dronemap.ws.virtual.VirtualDroneService;
import org.dronemap.ws.virtual.VirtualDroneViewMapper;
import org.dronemap.ws.virtual.WarehouseService;
import org.dronemap.ws.zone.ZoneService;
import org.jspecify.annotations.Nullable;

/** A server as {@link Dronemap} builds it, with the use cases that lead drones, and without faces and sockets. */
public final class SteppedServer implements AutoCloseable {
    private static final ServerSettings.Hidden GIVEN_LINK_SECRET =
            new ServerSettings.Hidden("0123456789abcdef".repeat(4));
    private static final ServerSettings.Hidden GIVEN_AUDIT_KEY =
            new ServerSettings.Hidden("fedcba9876543210".repeat(4));

    private final ShutdownSequence closing = new ShutdownSequence();
    private final ServerBuilder builder;
    private final ServerComponents house;
    private final DroneService drones;
    private final CommandService commands;
    private final SteeringService steering;
    private final PlanService plans;
    private final RunService runs;
    private final FollowService follows;
    private final DispatchService dispatches;
    private final RecoveryService recoveries;
    private final ZoneService zones;
    private final VirtualDroneService virtuals;
    private final WarehouseService warehouse;
    private final SteppedAccountServices accounts;
    private final BroadcastService broadcasts;
    private final ParameterService parameters;
    private final FenceService fences;
    private final OnboardLogService logs;
    private final SteppedLinkServices office;
    private final RunJournalService journals;

    /** It takes up what {@code stores} hold, and hears vehicles from now on. */
    public SteppedServer(Path data, Time time, Stores stores, ProcessStart beginning) {
        this(settings(data, GIVEN_LINK_SECRET, GIVEN_AUDIT_KEY), time, stores, beginning);
    }

    SteppedServer(ServerSettings settings, Time time, Stores stores) {
        this(settings, time, stores, ProcessStart.ORDINARY);
    }

    private SteppedServer(ServerSettings settings, Time time, Stores stores, ProcessStart beginning) {
        Path data = settings.dataDirectory();
        builder = new ServerBuilder(settings, closing, time, beginning);
        house = builder.open(stores);
        CloudManager cloud = house.cloud();
        Budgets budgets = new Budgets(BudgetRates.UNBOUNDED, time::nanos);
        DroneViewMapper shown = views(cloud);
        drones = new DroneService(cloud, shown);
        commands = new CommandService(cloud, drones, budgets, time);
        steering = new SteeringService(cloud, drones, budgets);
        zones = new ZoneService(
                new ZoneService.Stores(house.zones(), cloud.zones(), house.access()), drones, time.clock());
        PoolPlanDrones pool = new PoolPlanDrones(cloud, house.virtuals()::warehouse);
        OperationComponents operations = house.runs();
        plans = plans(operations, pool, time);
        RunService.OperationContext running =
                new RunService.OperationContext(operations.operations(), operations.kind(), cloud);
        runs = new RunService(running, plans, drones, time);
        closing.add("the zones of runs", RunZoneSynchronizer.start(running, time));
        joinOthers(running, pool, time);
        follows = follows(operations, cloud, time);
        dispatches = dispatches(operations, cloud, time);
        recoveries = recoveries(operations, cloud, time);
        VirtualDroneViewMapper views = new VirtualDroneViewMapper(cloud, house.virtuals());
        virtuals = new VirtualDroneService(house.virtuals(), views, time);
        warehouse = new WarehouseService(house.virtuals(), drones);
        accounts = new SteppedAccountServices(house, drones, time, closing);
        broadcasts = new BroadcastService(cloud, commands);
        parameters = new ParameterService(cloud, drones, commands);
        fences = new FenceService(cloud, drones, commands, time.clock());
        OnboardLogArchive shelf = new OnboardLogArchive(data.resolve("vehicle-logs"), time);
        closing.add("the logs of vehicles", shelf);
        logs = new OnboardLogService(cloud, drones, commands, shelf);
        office = SteppedLinkServices.of(house, settings, drones, shown, zones);
        journals = new RunJournalService(runs, operations.operations(), operations.kind());
        builder.openLinks();
        builder.serve();
    }

    private static DroneViewMapper views(CloudManager cloud) {
        return new DroneViewMapper(
                new DronePlaceNames(point -> null), cloud.controls(), cloud::sensed, cloud::cloudLoss);
    }

    private void joinOthers(RunService.OperationContext context, PoolPlanDrones pool, Time time) {
        OwnerRightsCache owners = new OwnerRightsCache(house.access(), house.grantBook(), time);
        closing.add("the pool of runs", RunPoolScheduler.start(context, pool, owners, time));
    }

    private PlanService plans(OperationComponents operations, PoolPlanDrones pool, Time time) {
        PlanJobExecutor jobs = new PlanJobExecutor(PlanJobExecutor.Limits.of(time.parallelism()), time);
        closing.add("the plans", jobs);
        PlanService.SeparationContext apart =
                new PlanService.SeparationContext(operations.apart(), new TakeOffClearance(operations.board(), time));
        return new PlanService(jobs, drones, commands, pool, house.cloud().zones(), apart, time);
    }

    private RecoveryService recoveries(OperationComponents operations, CloudManager cloud, Time time) {
        return new RecoveryService(
                new RecoveryService.OperationContext(
                        operations.operations(), operations.recoveries(), cloud, operations.apart()),
                List.of(runs::stop, follows::stop, dispatches::cancel),
                time);
    }

    private FollowService follows(OperationComponents operations, CloudManager cloud, Time time) {
        FollowService.OperationContext context =
                new FollowService.OperationContext(operations.operations(), operations.follows(), cloud);
        closing.add("the reliefs of follows", reliefs(context, time));
        return new FollowService(context, house.virtuals()::warehouse, time);
    }

    private DispatchService dispatches(OperationComponents operations, CloudManager cloud, Time time) {
        DispatchService.OperationContext context =
                new DispatchService.OperationContext(operations.operations(), operations.dispatches(), cloud);
        OwnerRightsCache rights = new OwnerRightsCache(house.access(), house.grantBook(), time);
        DispatchScheduler scheduler = new DispatchScheduler(context, house.virtuals()::warehouse, rights, time);
        scheduler.start();
        closing.add("the drones that are sent", scheduler);
        return new DispatchService(context, house.virtuals()::warehouse, time);
    }

    private FollowReliefScheduler reliefs(FollowService.OperationContext context, Time time) {
        OwnerRightsCache rights = new OwnerRightsCache(house.access(), house.grantBook(), time);
        FollowReliefScheduler reliefs = new FollowReliefScheduler(context, house.virtuals()::warehouse, rights, time);
        reliefs.start();
        return reliefs;
    }

    /** Without secrets: those in the folder. */
    static ServerSettings settings(
            Path data, ServerSettings.@Nullable Hidden linkSecret, ServerSettings.@Nullable Hidden auditKey) {
        return new ServerSettings(
                data,
                "127.0.0.1",
                0,
                0,
                List.of(),
                // Whoever attaches comes over links of memory.
                new OutletSettings(List.of(), true, PortRange.NONE),
                RobotSettings.OFF,
                Enrolment.LOOPBACK,
                null,
                false,
                null,
                null,
                Watchdog.DEFAULT,
                LeaseRules.DEFAULT,
                CloudManager.Rules.USUAL_LOSS_SECONDS,
                RecordingPolicy.DEFAULT,
                HistoryPolicy.DEFAULT,
                null,
                linkSecret,
                auditKey,
                RegistrationPolicy.APPROVAL,
                new ServerSettings.Protection(ClientLimits.DEFAULT, BudgetRates.UNBOUNDED),
                null,
                VirtualRunMachine.USUAL_SILENCE,
                Separation.USUAL,
                false);
    }

    /** Where links bring their bytes. */
    public PeerHandler.Factory links() {
        return builder.vehicles();
    }

    /** Where links of ground stations of other makers bring theirs. */
    public PeerHandler.Factory stations() {
        return builder.stations();
    }

    /** Where links of robots bring theirs. */
    public PeerHandler.Factory robots() {
        return builder.robots();
    }

    /** What users may do, and what they attach. */
    public SteppedAccountServices accounts() {
        return accounts;
    }

    public ServerComponents house() {
        return house;
    }

    public DroneService drones() {
        return drones;
    }

    public CommandService commands() {
        return commands;
    }

    public SteeringService steering() {
        return steering;
    }

    public PlanService plans() {
        return plans;
    }

    public RunService runs() {
        return runs;
    }

    public FollowService follows() {
        return follows;
    }

    public DispatchService dispatches() {
        return dispatches;
    }

    public RecoveryService recoveries() {
        return recoveries;
    }

    public ZoneService zones() {
        return zones;
    }

    public VirtualDroneService virtuals() {
        return virtuals;
    }

    public WarehouseService warehouse() {
        return warehouse;
    }

    public BroadcastService broadcasts() {
        return broadcasts;
    }

    public ParameterService parameters() {
        return parameters;
    }

    public FenceService fences() {
        return fences;
    }

    public OnboardLogService logs() {
        return logs;
    }

    public SteppedLinkServices office() {
        return office;
    }

    public RunJournalService journals() {
        return journals;
    }

    @Override
    public void close() {
        closing.close();
    }
}
