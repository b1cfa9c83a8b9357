import com.sun.tools.attach.VirtualMachine;
import java.lang.instrument.ClassFileTransformer;
import java.lang.instrument.Instrumentation;
import java.nio.ByteBuffer;
import java.security.ProtectionDomain;
import java.util.ArrayList;
import java.util.List;
import org.springframework.asm.ClassReader;
import org.springframework.asm.ClassVisitor;
import org.springframework.asm.ClassWriter;
import org.springframework.asm.MethodVisitor;
import org.springframework.asm.Opcodes;

/**
 * Faults for a server that runs, from outside it: {@code java -jar faults.jar PID FAULT} uses up its heap, its memory outside
 * the heap or its threads, or stops one of its threads; as an agent from the start, {@code frame} fails at every MAVLink
 * message of system {@value #BAD_SYSTEM}, and {@code journal} at every stored state of an operation.
 */
public final class Faults {
    private static final int BAD_SYSTEM = 66;
    private static final int SYSTEM_AT = 5;
    private static final List<Object> KEPT = new ArrayList<>();

    private Faults() {}

    public static void main(String[] arguments) throws Exception {
        VirtualMachine server = VirtualMachine.attach(arguments[0]);
        String jar = Faults.class.getProtectionDomain().getCodeSource().getLocation().getPath();
        server.loadAgent(jar, arguments[1]);
    }

    public static void agentmain(String fault, Instrumentation instrumentation) {
        new Thread(() -> begin(fault), "fault").start();
    }

    public static void premain(String fault, Instrumentation instrumentation) {
        if (fault.equals("frame")) {
            instrumentation.addTransformer(new Beginning(
                    "org/dronemap/proxy/session/VehiclePeerHandler", "received", "(Ljava/nio/ByteBuffer;)V", "onFrame"));
        } else {
            instrumentation.addTransformer(new Beginning("org/dronemap/ws/journal/JsonOperationCodec", "state", null, "onState"));
        }
    }

    private static void begin(String fault) {
        if (fault.startsWith("stop:")) {
            stop(fault.substring("stop:".length()));
            return;
        }
        long begun = System.nanoTime();
        boolean told = false;
        while (true) {
            try {
                take(fault);
            } catch (OutOfMemoryError e) {
                if (!told) {
                    told = true;
                    System.err.println(fault + " used up after " + (System.nanoTime() - begun) / 1_000_000 + " ms");
                }
                // It is somebody else's turn to find out.
                pause(20);
            }
        }
    }

    private static void take(String fault) {
        switch (fault) {
            case "heap" -> KEPT.add(new byte[1 << 20]);
            case "direct" -> KEPT.add(ByteBuffer.allocateDirect(1 << 20));
            case "threads" -> {
                Thread idle = new Thread(null, () -> pause(Long.MAX_VALUE), "idle", 1 << 16);
                idle.setDaemon(true);
                idle.start();
            }
            default -> throw new IllegalArgumentException(fault);
        }
    }

    @SuppressWarnings({"deprecation", "removal"})
    private static void stop(String name) {
        List<Thread> found = Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals(name))
                .toList();
        System.err.println("Stops " + found);
        found.forEach(Thread::stop);
    }

    private static void pause(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Called by the server's own class. */
    public static void onFrame(ByteBuffer bytes) {
        int at = bytes.position() + SYSTEM_AT;
        if (at < bytes.limit() && (bytes.get(at) & 0xff) == BAD_SYSTEM) {
            throw new InternalError("a frame that always fails");
        }
    }

    /** Called by the server's own class. */
    public static void onState(Object state) {
        if (state instanceof String) {
            // Of the machine, and yet no reason to end a server that somebody asks for it.
            throw new StackOverflowError("an entry that always fails");
        }
    }

    /** Calls one of the methods above at the beginning of methods of a class. */
    private record Beginning(String type, String method, String descriptor, String hook)
            implements ClassFileTransformer {
        @Override
        public byte[] transform(
                ClassLoader loader, String name, Class<?> before, ProtectionDomain domain, byte[] bytes) {
            if (!type.equals(name)) {
                return null;
            }
            ClassReader reader = new ClassReader(bytes);
            // Not made from the reader, which would copy methods past the visitor.
            ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
            reader.accept(new Rewriter(writer), 0);
            return writer.toByteArray();
        }

        private final class Rewriter extends ClassVisitor {
            Rewriter(ClassVisitor next) {
                super(Opcodes.ASM9, next);
            }

            @Override
            public MethodVisitor visitMethod(
                    int access, String name, String its, String signature, String[] exceptions) {
                MethodVisitor visitor = super.visitMethod(access, name, its, signature, exceptions);
                boolean hooked = name.equals(method)
                        && (access & Opcodes.ACC_BRIDGE) == 0
                        && (descriptor == null ? its.startsWith("(Ljava/lang/String;)") : its.equals(descriptor));
                if (hooked) {
                    visitor.visitCode();
                    visitor.visitVarInsn(Opcodes.ALOAD, 1);
                    String taken = descriptor == null ? "(Ljava/lang/Object;)V" : descriptor;
                    visitor.visitMethodInsn(Opcodes.INVOKESTATIC, "Faults", hook, taken, false);
                }
                return visitor;
            }
        }
    }
}
