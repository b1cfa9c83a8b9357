package org.dronemap.ws;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchRule;
import java.nio.channels.Selector;
import java.time.Clock;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.Timer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.BaseStream;
import org.dronemap.core.time.WaitStrategy;

/** What a flight depends on has its time and its threads from core.time, so that it can be stepped. */
final class TimeSourceRules {
    private TimeSourceRules() {}

    /** Those that may have time of their own, and why; all others are stepped in tests of whole flights. */
    static final Map<String, String> EXCEPTIONS = Map.of(
            "org.dronemap.proxy.endpoint.UdpServerEndpoint",
            "It rests between bursts of datagrams; nobody can step what waits for a socket.",
            "org.dronemap.proxy.endpoint.TcpServerEndpoint",
            "It waits at most so long for a socket, as those held back go on when time has gone by.",
            "org.dronemap.proxy.endpoint.WebSocketConnection",
            "It waits for messages that the library's thread brings, and holds that one back.",
            "org.dronemap.proxy.endpoint.BoundedWebSocketFactory",
            "The library wants an executor for TLS handshakes.",
            "org.dronemap.proxy.endpoint.TimedChannelReader",
            "It waits at most so long for a socket, as whoever dialled it greets meanwhile.",
            "org.dronemap.cognitive.allocate.NeighbourLists",
            "Arithmetic that comes to the same on as many threads as there are, and waits for nothing else.");

    /** Classes of ws that decide about flights, or build what does. */
    static final Set<String> OF_WS = Set.of(
            "org.dronemap.ws.command.BroadcastService",
            "org.dronemap.ws.command.CommandService",
            "org.dronemap.ws.control.ControlService",
            "org.dronemap.ws.fence.FenceService",
            "org.dronemap.ws.operation.PoolDroneSelector",
            "org.dronemap.ws.follow.FollowReliefScheduler",
            "org.dronemap.ws.follow.FollowService",
            "org.dronemap.ws.mission.MissionService",
            "org.dronemap.ws.operation.OperationService",
            "org.dronemap.ws.parameter.ParameterService",
            "org.dronemap.ws.plan.PlanJobExecutor",
            "org.dronemap.ws.plan.DroneLaunchStatus",
            "org.dronemap.ws.plan.PlanJob",
            "org.dronemap.ws.plan.PlanLauncher",
            "org.dronemap.ws.plan.PlanService",
            "org.dronemap.ws.run.RunService",
            "org.dronemap.ws.run.RunZoneSynchronizer",
            "org.dronemap.ws.control.SteeringService",
            "org.dronemap.ws.command.TakeOffInserter",
            "org.dronemap.ws.plan.TourService",
            "org.dronemap.ws.virtual.VirtualDroneService",
            "org.dronemap.ws.enrol.EnrolmentService",
            "org.dronemap.ws.zone.ZoneService",
            "org.dronemap.ws.operation.OwnerRightsCache",
            "org.dronemap.ws.server.AuditBuilder",
            "org.dronemap.ws.server.AuditedOutletControl",
            "org.dronemap.ws.server.HistoryBuilder",
            "org.dronemap.ws.server.ServerBuilder",
            "org.dronemap.ws.server.OutletBuilder",
            "org.dronemap.ws.server.RobotEndpointBuilder",
            "org.dronemap.ws.schedule.PeriodicTask",
            "org.dronemap.ws.server.OperationComponents",
            "org.dronemap.ws.wiring.ServiceConfiguration");

    private static final List<String> PACKAGES =
            List.of("org.dronemap.core", "org.dronemap.cognitive", "org.dronemap.proxy");
    private static final String TIME = "org.dronemap.core.time";

    private static final Set<String> ON_A_COMMON_POOL =
            Set.of("delayedExecutor", "orTimeout", "completeOnTimeout", "defaultExecutor");

    static final ArchRule WHAT_FLIES_HAS_ITS_TIME_FROM_OUTSIDE =
            noneOf(classes("what flies", type -> isOfFlight(type) && !EXCEPTIONS.containsKey(outermost(type))));

    static ArchRule noneOf(DescribedPredicate<JavaClass> which) {
        return noClasses()
                .that(which)
                .should()
                .accessTargetWhere(new DescribedPredicate<JavaAccess<?>>("it is time or a thread of one's own") {
                    @Override
                    public boolean test(JavaAccess<?> access) {
                        return access.getTarget() instanceof AccessTarget.CodeUnitAccessTarget target
                                && (isAClock(target) || isAThread(target) || isARest(target) || isATimedWait(target));
                    }
                })
                .as("what decides about flights has its time and its threads from core.time");
    }

    static DescribedPredicate<JavaClass> only(String name) {
        return classes(name, type -> outermost(type).equals(name));
    }

    private interface Look {
        boolean at(JavaClass type);
    }

    private static DescribedPredicate<JavaClass> classes(String description, Look look) {
        return new DescribedPredicate<>(description) {
            @Override
            public boolean test(JavaClass type) {
                return look.at(type);
            }
        };
    }

    static boolean isOfFlight(JavaClass type) {
        return OF_WS.contains(outermost(type))
                || (PACKAGES.stream().anyMatch(name -> isIn(type, name)) && !isIn(type, TIME));
    }

    private static boolean isIn(JavaClass type, String name) {
        return type.getPackageName().equals(name) || type.getPackageName().startsWith(name + ".");
    }

    private static String outermost(JavaClass type) {
        int inner = type.getName().indexOf('$');
        return inner < 0 ? type.getName() : type.getName().substring(0, inner);
    }

    private static boolean isAClock(AccessTarget.CodeUnitAccessTarget target) {
        JavaClass owner = target.getOwner();
        String name = target.getName();
        boolean ofAnother = takes(target, Clock.class);
        return is(target, System.class, "nanoTime", "currentTimeMillis")
                || is(target, InstantSource.class, "system")
                || (!ofAnother && isIn(owner, "java.time") && name.equals("now"))
                || (!ofAnother
                        && owner.isEquivalentTo(Clock.class)
                        && (name.startsWith("system") || name.startsWith("tick")));
    }

    private static boolean isAThread(AccessTarget.CodeUnitAccessTarget target) {
        JavaClass owner = target.getOwner();
        boolean made = target.getName().equals("<init>");
        return (made
                        && (owner.isAssignableTo(Thread.class)
                                || owner.isAssignableTo(Timer.class)
                                || (owner.isAssignableTo(Executor.class) && isIn(owner, "java.util.concurrent"))))
                || owner.isEquivalentTo(Executors.class)
                || (owner.isEquivalentTo(ForkJoinPool.class) && target.getName().equals("commonPool"))
                || isOnACommonPool(target);
    }

    private static boolean isOnACommonPool(AccessTarget.CodeUnitAccessTarget target) {
        JavaClass owner = target.getOwner();
        String name = target.getName();
        boolean future = owner.isAssignableTo(CompletionStage.class) && isIn(owner, "java.util.concurrent");
        return (future && name.endsWith("Async") && !takes(target, Executor.class))
                || (owner.isEquivalentTo(CompletableFuture.class) && ON_A_COMMON_POOL.contains(name))
                || name.equals("parallelStream")
                || (owner.isAssignableTo(BaseStream.class) && name.equals("parallel"));
    }

    private static boolean isARest(AccessTarget.CodeUnitAccessTarget target) {
        return is(target, Thread.class, "sleep")
                || is(target, TimeUnit.class, "sleep", "timedWait", "timedJoin")
                || is(target, LockSupport.class, "parkNanos", "parkUntil")
                || is(target, WaitStrategy.class, "pause");
    }

    private static boolean isATimedWait(AccessTarget.CodeUnitAccessTarget target) {
        JavaClass owner = target.getOwner();
        boolean timed = takes(target, long.class);
        return (timed && is(target, Object.class, "wait"))
                || (timed
                        && owner.isAssignableTo(Selector.class)
                        && target.getName().equals("select"))
                // poll, offer, get, await, tryAcquire, tryLock, schedule, waitFor and whatever else.
                || (isIn(owner, "java") && !owner.isAssignableTo(TimeUnit.class) && takes(target, TimeUnit.class));
    }

    private static boolean is(AccessTarget.CodeUnitAccessTarget target, Class<?> owner, String... names) {
        return target.getOwner().isEquivalentTo(owner) && List.of(names).contains(target.getName());
    }

    private static boolean takes(AccessTarget.CodeUnitAccessTarget target, Class<?> type) {
        return target.getRawParameterTypes().stream().anyMatch(parameter -> parameter.isEquivalentTo(type));
    }
}
