// SPDX-License-Identifier: MIT
//! Correctly rounded collision queries, scenes and worlds with the same bits on every machine: the C
//! interface of detent, without dependencies.
//!
//! All numbers are raw integers: a length of 1 is [`ONE`], a direction's component of 1 is
//! [`UNIT`]. The modules [`d2`] and [`d3`] have the shapes, rays, scenes and worlds of each
//! dimension.
//!
//! ```
//! use detent::{d3, Context, Traits, ONE, UNIT};
//!
//! let context = Context::new()?;
//! let mut scene = d3::Scene::new(&context)?;
//! let ball = scene.add(&d3::sphere([10 * ONE, 0, 0], ONE), Traits::default())?;
//! let hit = scene.raycast(&d3::ray([0, 0, 0], [UNIT, 0, 0], 100 * ONE), !0)?.unwrap();
//! assert_eq!((hit.id, hit.distance), (ball, 9 * ONE));
//! # Ok::<(), detent::Error>(())
//! ```

#![warn(missing_docs)]

#[rustfmt::skip]
pub mod ffi;

use std::cell::UnsafeCell;
use std::ffi::CStr;
use std::fmt;
use std::marker::PhantomData;

pub use ffi::{Found, Id, Impact, Pair, ReplayCheck, SessionSettings, SessionStatus, Touch, Traits};

/// The length 1.
pub const ONE: i32 = 1 << 16;
/// The component 1 of a direction.
pub const UNIT: i32 = 1 << 30;

/// A failed call, with the negative status of the C interface.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Error(pub i32);

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let words = unsafe { CStr::from_ptr(ffi::detent_describe(self.0)) };
        out.write_str(&words.to_string_lossy())
    }
}
impl fmt::Debug for Error {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        write!(out, "Error({}: {})", self.0, self)
    }
}
impl std::error::Error for Error {}

impl Default for Traits {
    /// A moving object in layer 1 and no frame, with user word 0.
    fn default() -> Traits {
        Traits { user: 0, layers: 1, motion: ffi::MOVING, frame: Id::default() }
    }
}

/// The result of a function that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// True for yes or done, false for no or none.
fn check(status: i32) -> Result<bool> {
    if status < 0 {
        return Err(Error(status));
    }
    Ok(status == ffi::OK)
}

/// The nearest length to a number; `None` out of range and for NaN. Halves are rounded away from 0.
pub fn raw(value: f64) -> Option<i32> {
    let scaled = (value * f64::from(ONE)).round();
    if scaled >= -2147483648.0 && scaled <= 2147483647.0 {
        Some(scaled as i32)
    } else {
        None
    }
}

/// Changes whenever any result changes by a bit.
pub fn results_version() -> i32 {
    unsafe { ffi::detent_results_version() }
}

/// Holds scenes, worlds and assets, which borrow it. Contexts of different threads are independent.
pub struct Context {
    // Boxed, because an open context must not move; not Sync.
    open: Box<UnsafeCell<ffi::Context>>,
}

impl Context {
    /// An open context.
    pub fn new() -> Result<Context> {
        let context = Context { open: Box::new(UnsafeCell::new(ffi::Context::default())) };
        check(unsafe { ffi::detent_open(context.pointer(), std::ptr::null()) })?;
        Ok(context)
    }

    fn pointer(&self) -> *mut ffi::Context {
        self.open.get()
    }

    /// A mesh; each triangle is three vertex indices. `name` is its id in snapshots, not 0.
    pub fn mesh(&self, name: u32, vertices: &[[i32; 3]], faces: &[[u32; 3]]) -> Result<Asset<'_>> {
        let points: Vec<_> = vertices.iter().map(|v| d3::vec(*v)).collect();
        let mut handle = 0;
        check(unsafe {
            ffi::detent_mesh_create(
                self.pointer(),
                name,
                points.as_ptr(),
                length(&points)?,
                faces.as_ptr().cast(),
                length(faces)?,
                &mut handle,
            )
        })?;
        Ok(Asset { context: self, handle })
    }

    /// A 3D height field of `columns` times `rows` heights.
    pub fn height_field(
        &self,
        name: u32,
        corner: [i32; 2],
        cell: i32,
        columns: u32,
        rows: u32,
        heights: &[i32],
    ) -> Result<Asset<'_>> {
        if heights.len() as u64 != u64::from(columns) * u64::from(rows) {
            return Err(Error(ffi::BAD_ARGUMENT));
        }
        let mut handle = 0;
        check(unsafe {
            ffi::detent_height_field_create(
                self.pointer(),
                name,
                &d2::vec(corner),
                cell,
                columns,
                rows,
                heights.as_ptr(),
                &mut handle,
            )
        })?;
        Ok(Asset { context: self, handle })
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        unsafe { ffi::detent_close(self.pointer()) };
    }
}

fn length<T>(list: &[T]) -> Result<u32> {
    if list.len() > u32::MAX as usize {
        return Err(Error(ffi::BAD_ARGUMENT));
    }
    Ok(list.len() as u32)
}

/// An asset: a mesh, hull or height field for objects of scenes, or a solid hull for bodies. It
/// lives as long as the context, or until `destroy`.
pub struct Asset<'a> {
    context: &'a Context,
    handle: u32,
}

impl Asset<'_> {
    /// Destroys it. An error while an object or body refers to it.
    pub fn destroy(&self) -> Result<()> {
        check(unsafe { ffi::detent_asset_destroy(self.context.pointer(), self.handle) }).map(|_| ())
    }
}

/// All results of a call that writes a list.
fn list<T: Clone + Default>(call: impl Fn(*mut T, u32, *mut u32) -> i32) -> Result<Vec<T>> {
    let mut items = vec![T::default(); 64];
    loop {
        let mut count = 0;
        check(call(items.as_mut_ptr(), length(&items)?, &mut count))?;
        let count = count as usize;
        if count <= items.len() {
            items.truncate(count);
            return Ok(items);
        }
        items.resize(count, T::default());
    }
}

/// The bytes of a snapshot.
fn bytes(call: impl Fn(*mut std::os::raw::c_void, u32, *mut u32) -> i32) -> Result<Vec<u8>> {
    let mut size = 0;
    check(call(std::ptr::null_mut(), 0, &mut size))?;
    let mut room = vec![0; size as usize];
    check(call(room.as_mut_ptr().cast(), size, &mut size))?;
    Ok(room)
}

/// The default settings of a session.
pub fn session_settings() -> SessionSettings {
    let mut own = SessionSettings::default();
    unsafe { ffi::detent_session_default_settings(&mut own) };
    own
}

/// A frame to simulate: its number, and the input of each player.
pub struct Frame {
    frame: ffi::Frame,
    inputs: [u8; 128],
    input_size: usize,
}

impl Frame {
    fn new(input_size: usize) -> Frame {
        Frame { frame: ffi::Frame::default(), inputs: [0; 128], input_size }
    }
    /// The number of the frame, from 0.
    pub fn number(&self) -> u32 {
        self.frame.number
    }
    /// The number of players, including those who left.
    pub fn players(&self) -> usize {
        self.frame.players as usize
    }
    /// A player's input; `None` if it takes no part.
    pub fn input(&self, player: usize) -> Option<&[u8]> {
        let is_in = player < self.players() && self.frame.present >> player & 1 != 0;
        let start = player * self.input_size;
        if is_in { Some(&self.inputs[start..start + self.input_size]) } else { None }
    }
}

/// An event of a session.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// Such as `ffi::DESYNC`.
    pub kind: u32,
    /// The peer concerned.
    pub peer: u32,
    /// The frame concerned.
    pub frame: u32,
    /// The name of the field that differs.
    pub field: String,
    /// The body that the field belongs to.
    pub object: Option<Id>,
}

macro_rules! space {
    ($name:ident, $doc:literal, $n:literal, $spin:literal, [$($i:literal $x:ident),*],
     $Vec:ident $Direction:ident $Rotation:ident $Transform:ident $Ray:ident $Shape:ident
     $ShapeAs:ident $Hit:ident $ObjectHit:ident $Settings:ident $Options:ident $Body:ident
     $Sphere:ident $Aabb:ident $Obb:ident $Plane:ident $Triangle:ident $Capsule:ident
     $Segment:ident $ContactPoint:ident $Manifold:ident $Sweep:ident $Joint:ident $Contact:ident
     $Mover:ident $MoverSettings:ident $Move:ident $Part:ident;
     $($alias:ident = $function:ident,)*) => {
        #[doc = $doc]
        pub mod $name {
            use super::*;
            $(use crate::ffi::$function as $alias;)*
            pub use crate::ffi::{
                $Body as Body, $Hit as Hit, $ObjectHit as ObjectHit, $Options as BodyOptions,
                $ContactPoint as ContactPoint, $Joint as Joint, $Manifold as Manifold, $Move as Move,
                $Mover as Mover, $MoverSettings as MoverSettings, $Ray as Ray,
                $Part as Part, $Settings as WorldSettings, $Shape as Shape, $Sweep as Sweep,
                $Contact as WorldContact, $Transform as Transform,
            };

            pub(crate) fn vec(v: [i32; $n]) -> ffi::$Vec {
                ffi::$Vec { $($x: v[$i]),* }
            }
            fn direction(v: [i32; $n]) -> ffi::$Direction {
                ffi::$Direction { $($x: v[$i]),* }
            }
            fn rotation(axes: [[i32; $n]; $n]) -> ffi::$Rotation {
                ffi::$Rotation { axis: [$(direction(axes[$i])),*] }
            }
            fn made(kind: u32, of: ffi::$ShapeAs) -> Shape {
                Shape { kind, asset: 0, of }
            }

            /// The axes of the world.
            pub const AXES: [[i32; $n]; $n] = {
                let mut axes = [[0; $n]; $n];
                $(axes[$i][$i] = UNIT;)*
                axes
            };

            /// The points from `origin` along `toward`, a unit vector, up to `max_distance`.
            pub fn ray(origin: [i32; $n], toward: [i32; $n], max_distance: i32) -> Ray {
                Ray { origin: vec(origin), direction: direction(toward), max_distance }
            }
            /// The points within `radius` of `center`.
            pub fn sphere(center: [i32; $n], radius: i32) -> Shape {
                made(ffi::SPHERE, ffi::$ShapeAs { sphere: ffi::$Sphere { center: vec(center), radius } })
            }
            /// The points between two corners.
            pub fn aabb(min: [i32; $n], max: [i32; $n]) -> Shape {
                made(ffi::AABB, ffi::$ShapeAs { aabb: ffi::$Aabb { min: vec(min), max: vec(max) } })
            }
            /// A box with the given axes, such as `AXES`.
            pub fn obb(center: [i32; $n], half_extents: [i32; $n], axes: [[i32; $n]; $n]) -> Shape {
                let (center, half_extents) = (vec(center), vec(half_extents));
                let rotation = rotation(axes);
                made(ffi::OBB, ffi::$ShapeAs { obb: ffi::$Obb { center, half_extents, rotation } })
            }
            /// The points x with dot(normal, x) = offset.
            pub fn plane(normal: [i32; $n], offset: i32) -> Shape {
                let normal = direction(normal);
                made(ffi::PLANE, ffi::$ShapeAs { plane: ffi::$Plane { normal, offset } })
            }
            /// The points of the triangle with these corners.
            pub fn triangle(a: [i32; $n], b: [i32; $n], c: [i32; $n]) -> Shape {
                let triangle = ffi::$Triangle { a: vec(a), b: vec(b), c: vec(c) };
                made(ffi::TRIANGLE, ffi::$ShapeAs { triangle })
            }
            /// The points within `radius` of a segment.
            pub fn capsule(a: [i32; $n], b: [i32; $n], radius: i32) -> Shape {
                let capsule = ffi::$Capsule { a: vec(a), b: vec(b), radius };
                made(ffi::CAPSULE, ffi::$ShapeAs { capsule })
            }
            /// A segment; queries only.
            pub fn segment(start: [i32; $n], end: [i32; $n]) -> Shape {
                let segment = ffi::$Segment { start: vec(start), end: vec(end) };
                made(ffi::SEGMENT, ffi::$ShapeAs { segment })
            }
            /// A point; queries of scenes only.
            pub fn point(at: [i32; $n]) -> Shape {
                made(ffi::POINT, ffi::$ShapeAs { point: vec(at) })
            }
            /// An asset as a shape. In a scene: a transformed mesh or hull, or a translated height
            /// field. In a world also a solid hull or a compound.
            pub fn placed(asset: &Asset, translation: [i32; $n], axes: [[i32; $n]; $n],
                          scale: i32) -> Shape {
                let translation = vec(translation);
                let kind = match asset.handle & 31 {
                    5 => ffi::MESH,
                    8 => ffi::HEIGHT_FIELD,
                    11 | 12 => ffi::COMPOUND,
                    _ => ffi::HULL,
                };
                let of = if kind == ffi::HEIGHT_FIELD {
                    ffi::$ShapeAs { point: translation }
                } else {
                    let rotation = rotation(axes);
                    ffi::$ShapeAs { placed: ffi::$Transform { translation, rotation, scale } }
                };
                Shape { kind, asset: asset.handle, of }
            }

            /// The first point where the ray touches the shape.
            pub fn raycast(ray: &Ray, shape: &Shape) -> Result<Option<Hit>> {
                let mut hit = Hit::default();
                Ok(if check(unsafe { raycast_(ray, shape, &mut hit) })? { Some(hit) } else { None })
            }
            /// The distances of many rays; -1 for a miss.
            pub fn raycast_many(rays: &[Ray], shape: &Shape) -> Result<Vec<i32>> {
                let mut distances = vec![0; rays.len()];
                check(unsafe {
                    raycast_many_(rays.as_ptr(), length(rays)?, shape, distances.as_mut_ptr())
                })?;
                Ok(distances)
            }
            /// Whether the point is in the shape or on its surface.
            pub fn contains(shape: &Shape, at: [i32; $n]) -> Result<bool> {
                check(unsafe { contains_(shape, &vec(at)) })
            }
            /// Whether two shapes share a point.
            pub fn overlaps(a: &Shape, b: &Shape) -> Result<bool> {
                check(unsafe { overlaps_(a, b) })
            }
            /// The closest point of the shape to a point.
            pub fn closest_point(shape: &Shape, at: [i32; $n]) -> Result<[i32; $n]> {
                let mut closest = ffi::$Vec::default();
                check(unsafe { closest_point_(shape, &vec(at), &mut closest) })?;
                Ok([$(closest.$x),*])
            }
            /// The distance from a shape to a point, rounded down.
            pub fn distance_to_point(shape: &Shape, at: [i32; $n]) -> Result<i32> {
                let mut distance = 0;
                check(unsafe { distance_to_point_(shape, &vec(at), &mut distance) })?;
                Ok(distance)
            }
            /// The distance between two shapes, rounded down.
            pub fn distance(a: &Shape, b: &Shape) -> Result<i32> {
                let mut distance = 0;
                check(unsafe { distance_(a, b, &mut distance) })?;
                Ok(distance)
            }

            /// The contact of two overlapping shapes; the first `count` of its points are set.
            pub fn contact(a: &Shape, b: &Shape) -> Result<Option<Manifold>> {
                let mut found = Manifold::default();
                Ok(if check(unsafe { contact_(a, b, &mut found) })? { Some(found) } else { None })
            }
            /// The closest points of two shapes.
            pub fn closest_points(a: &Shape, b: &Shape) -> Result<([i32; $n], [i32; $n])> {
                let (mut one, mut other) = (ffi::$Vec::default(), ffi::$Vec::default());
                check(unsafe { closest_points_(a, b, &mut one, &mut other) })?;
                Ok(([$(one.$x),*], [$(other.$x),*]))
            }
            /// The first contact of a shape moving along `toward`, a unit vector, with a target.
            pub fn cast(shape: &Shape, toward: [i32; $n], max_distance: i32, target: &Shape)
                        -> Result<Option<Hit>> {
                let mut hit = Hit::default();
                let toward = direction(toward);
                let yes = check(unsafe { cast_(shape, &toward, max_distance, target, &mut hit) })?;
                Ok(if yes { Some(hit) } else { None })
            }
            /// The motion of a frame that does not rotate.
            pub fn sweep(start: [i32; $n], end: [i32; $n]) -> Sweep {
                let (start_rotation, end_rotation) = (rotation(AXES), rotation(AXES));
                Sweep { start: vec(start), end: vec(end), start_rotation, end_rotation }
            }
            /// When two moving shapes first come closer than `target`. A shape without a sweep does
            /// not move.
            pub fn time_of_impact(a: &Shape, sweep_a: &Sweep, b: &Shape, sweep_b: Option<&Sweep>,
                                  target: i32) -> Result<Option<Impact>> {
                let mut impact = Impact::default();
                let sweep_b = sweep_b.map_or(std::ptr::null(), |sweep| sweep as *const _);
                let yes = check(unsafe {
                    time_of_impact_(a, sweep_a, b, sweep_b, target, &mut impact)
                })?;
                Ok(if yes { Some(impact) } else { None })
            }

            /// The convex hull of at most 32 points, for bodies; it must have a volume.
            pub fn solid<'a>(context: &'a Context, name: u32, points: &[[i32; $n]])
                             -> Result<Asset<'a>> {
                let points: Vec<_> = points.iter().map(|p| vec(*p)).collect();
                let mut handle = 0;
                check(unsafe {
                    solid_create(context.pointer(), name, points.as_ptr(), length(&points)?,
                                 &mut handle)
                })?;
                Ok(Asset { context, handle })
            }
            /// A part of a compound with the default material.
            pub fn part(shape: Shape) -> Part {
                let mut own = Part {
                    shape, density: 0, friction: 0, restitution: 0, rolling_resistance: 0,
                    is_sensor: 0,
                };
                unsafe { part_defaults(&mut own) };
                own.shape = shape;
                own
            }
            /// Shapes that move as one body: spheres, AABBs, OBBs, capsules and placed solid hulls.
            pub fn compound<'a>(context: &'a Context, name: u32, parts: &[Part])
                                -> Result<Asset<'a>> {
                let mut handle = 0;
                check(unsafe {
                    compound_create(context.pointer(), name, parts.as_ptr(), length(parts)?,
                                    &mut handle)
                })?;
                Ok(Asset { context, handle })
            }
            /// A capsule character from `a` to `b`, in the air.
            pub fn mover(a: [i32; $n], b: [i32; $n], radius: i32) -> Mover {
                mover_of(capsule(a, b, radius))
            }
            /// An AABB character, in the air.
            pub fn box_mover(min: [i32; $n], max: [i32; $n]) -> Mover {
                mover_of(aabb(min, max))
            }
            fn mover_of(shape: Shape) -> Mover {
                Mover {
                    shape, is_grounded: 0, object: Id::default(), frame: Id::default(),
                    normal: Default::default(), local: Default::default(), point: Default::default(),
                }
            }
            /// The default settings of a character.
            pub fn mover_settings() -> MoverSettings {
                let mut own = MoverSettings::default();
                unsafe { mover_default_settings(&mut own) };
                own
            }
            /// The part of a velocity that does not lead into anything the character touched in a
            /// move.
            pub fn clip_velocity(velocity: [i32; $n], result: &Move) -> Result<[i32; $n]> {
                let mut clipped = ffi::$Vec::default();
                check(unsafe { mover_clip_velocity(&vec(velocity), result, &mut clipped) })?;
                Ok([$(clipped.$x),*])
            }
            /// A joint of a kind, such as `ffi::HINGE_JOINT`, with default fields.
            pub fn joint(kind: u32, a: Id, b: Id) -> Result<Joint> {
                let mut joint = Joint::default();
                check(unsafe { joint_defaults(kind, &mut joint) })?;
                Ok(Joint { a, b, ..joint })
            }

            /// The convex hull of at most 64 points. `name` is its id in snapshots, not 0.
            pub fn hull<'a>(context: &'a Context, name: u32, points: &[[i32; $n]]) -> Result<Asset<'a>> {
                let points: Vec<_> = points.iter().map(|p| vec(*p)).collect();
                let mut handle = 0;
                check(unsafe {
                    hull_create(context.pointer(), name, points.as_ptr(), length(&points)?, &mut handle)
                })?;
                Ok(Asset { context, handle })
            }

            /// Objects and queries over them. Destroyed on drop.
            pub struct Scene<'a> {
                context: &'a Context,
                handle: u32,
                not_sync: PhantomData<*mut ()>,
            }

            impl<'a> Scene<'a> {
                /// An empty scene.
                pub fn new(context: &'a Context) -> Result<Scene<'a>> {
                    let mut handle = 0;
                    check(unsafe { scene_create(context.pointer(), &mut handle) })?;
                    Ok(Scene { context, handle, not_sync: PhantomData })
                }
                fn at(&self) -> *mut ffi::Context {
                    self.context.pointer()
                }
                /// Adds an object.
                pub fn add(&mut self, shape: &Shape, traits: Traits) -> Result<Id> {
                    let mut id = Id::default();
                    check(unsafe { scene_add(self.at(), self.handle, shape, &traits, &mut id) })?;
                    Ok(id)
                }
                /// Removes an object; false if no object has this id.
                pub fn remove(&mut self, id: Id) -> Result<bool> {
                    check(unsafe { scene_remove(self.at(), self.handle, id) })
                }
                /// Replaces the shape of an object.
                pub fn replace(&mut self, id: Id, shape: &Shape) -> Result<bool> {
                    check(unsafe { scene_replace(self.at(), self.handle, id, shape) })
                }
                /// Translates an object.
                pub fn move_by(&mut self, id: Id, by: [i32; $n]) -> Result<bool> {
                    check(unsafe { scene_move(self.at(), self.handle, id, &vec(by)) })
                }
                /// The first object that a moving sphere, capsule or segment touches.
                pub fn cast(&self, shape: &Shape, toward: [i32; $n], max_distance: i32, layers: u32)
                            -> Result<Option<ObjectHit>> {
                    let mut hit = ObjectHit::default();
                    let toward = direction(toward);
                    let yes = check(unsafe {
                        scene_cast(self.at(), self.handle, shape, &toward, max_distance, layers,
                                   &mut hit)
                    })?;
                    Ok(if yes { Some(hit) } else { None })
                }
                /// Whether the moving shape touches any object.
                pub fn cast_any(&self, shape: &Shape, toward: [i32; $n], max_distance: i32,
                                layers: u32) -> Result<bool> {
                    let toward = direction(toward);
                    check(unsafe {
                        scene_cast_any(self.at(), self.handle, shape, &toward, max_distance, layers)
                    })
                }
                /// All objects that the moving shape touches, sorted by distance, then id.
                pub fn cast_all(&self, shape: &Shape, toward: [i32; $n], max_distance: i32,
                                layers: u32) -> Result<Vec<ObjectHit>> {
                    let toward = direction(toward);
                    list(|to, room, count| unsafe {
                        scene_cast_all(self.at(), self.handle, shape, &toward, max_distance, layers,
                                       to, room, count)
                    })
                }
                /// Moves a character by a vector, gravity included, as far as the objects in
                /// `layers` other than `ignored` allow.
                pub fn move_character(&self, mover: &mut Mover, by: [i32; $n],
                                      settings: &MoverSettings, layers: u32, ignored: Id)
                                      -> Result<Move> {
                    let mut result = Move::default();
                    check(unsafe {
                        mover_move(self.at(), self.handle, mover, &vec(by), settings, layers, ignored,
                                   &mut result)
                    })?;
                    Ok(result)
                }
                /// Adds a frame that carries objects; `None` if the parent does not exist.
                /// `Id::default()` is the world.
                pub fn add_frame(&mut self, translation: [i32; $n], axes: [[i32; $n]; $n], scale: i32,
                                 parent: Id) -> Result<Option<Id>> {
                    let mut id = Id::default();
                    let (translation, rotation) = (vec(translation), rotation(axes));
                    let transform = ffi::$Transform { translation, rotation, scale };
                    let done = check(unsafe {
                        scene_add_frame(self.at(), self.handle, &transform, parent, &mut id)
                    })?;
                    Ok(if done { Some(id) } else { None })
                }
                /// Moves a frame and everything in it.
                pub fn move_frame(&mut self, frame: Id, translation: [i32; $n],
                                  axes: [[i32; $n]; $n], scale: i32) -> Result<bool> {
                    let (translation, rotation) = (vec(translation), rotation(axes));
                    let transform = ffi::$Transform { translation, rotation, scale };
                    check(unsafe { scene_move_frame(self.at(), self.handle, frame, &transform) })
                }
                /// Removes a frame; false if it is not empty.
                pub fn remove_frame(&mut self, frame: Id) -> Result<bool> {
                    check(unsafe { scene_remove_frame(self.at(), self.handle, frame) })
                }
                /// Holds the shapes of the world's bodies, with their ids, and nothing else: call it
                /// after each step, or whenever queries are due. Sensors only if asked for.
                pub fn follow(&mut self, world: &World<'a>, sensors: bool) -> Result<()> {
                    check(unsafe {
                        scene_follow(self.at(), self.handle, world.handle, sensors as u32)
                    })
                    .map(|_| ())
                }
                /// Speeds up queries after many additions.
                pub fn optimize(&mut self) -> Result<()> {
                    check(unsafe { scene_optimize(self.at(), self.handle) }).map(|_| ())
                }
                /// The number of objects.
                pub fn size(&self) -> Result<u32> {
                    let mut size = 0;
                    check(unsafe { scene_size(self.at(), self.handle, &mut size) })?;
                    Ok(size)
                }
                /// The first object in `layers` that the ray touches.
                pub fn raycast(&self, ray: &Ray, layers: u32) -> Result<Option<ObjectHit>> {
                    let mut hit = ObjectHit::default();
                    let yes = check(unsafe {
                        scene_raycast(self.at(), self.handle, ray, layers, &mut hit)
                    })?;
                    Ok(if yes { Some(hit) } else { None })
                }
                /// Whether the ray touches any object in `layers`.
                pub fn raycast_any(&self, ray: &Ray, layers: u32) -> Result<bool> {
                    check(unsafe { scene_raycast_any(self.at(), self.handle, ray, layers) })
                }
                /// All objects in `layers` that the ray touches, sorted by distance, then id.
                pub fn raycast_all(&self, ray: &Ray, layers: u32) -> Result<Vec<ObjectHit>> {
                    list(|to, room, count| unsafe {
                        scene_raycast_all(self.at(), self.handle, ray, layers, to, room, count)
                    })
                }
                /// `raycast` for many rays; the distance of a miss is -1.
                pub fn raycast_many(&self, rays: &[Ray], layers: u32) -> Result<Vec<ObjectHit>> {
                    let mut hits = vec![ObjectHit::default(); rays.len()];
                    check(unsafe {
                        scene_raycast_many(self.at(), self.handle, rays.as_ptr(), length(rays)?,
                                           layers, hits.as_mut_ptr())
                    })?;
                    Ok(hits)
                }
                /// The object nearest to a point, or the nearest that a shape overlaps.
                pub fn nearest(&self, question: &Shape, layers: u32) -> Result<Option<Found>> {
                    let mut found = Found::default();
                    let yes = check(unsafe {
                        scene_nearest(self.at(), self.handle, question, layers, &mut found)
                    })?;
                    Ok(if yes { Some(found) } else { None })
                }
                /// Whether the shape overlaps any object in `layers`.
                pub fn any(&self, question: &Shape, layers: u32) -> Result<bool> {
                    check(unsafe { scene_any(self.at(), self.handle, question, layers) })
                }
                /// All objects in `layers` that the shape overlaps, sorted by distance, then id.
                pub fn all(&self, question: &Shape, layers: u32) -> Result<Vec<Found>> {
                    list(|to, room, count| unsafe {
                        scene_all(self.at(), self.handle, question, layers, to, room, count)
                    })
                }
                /// All pairs of overlapping objects.
                pub fn overlaps(&self) -> Result<Vec<Pair>> {
                    list(|to, room, count| unsafe {
                        scene_overlaps(self.at(), self.handle, to, room, count)
                    })
                }
                /// A 64-bit digest of all objects.
                pub fn digest(&self) -> Result<u64> {
                    let mut digest = 0;
                    check(unsafe { scene_digest(self.at(), self.handle, &mut digest) })?;
                    Ok(digest)
                }
                /// The moving objects as bytes.
                pub fn snapshot(&self) -> Result<Vec<u8>> {
                    bytes(|to, room, size| unsafe {
                        scene_snapshot(self.at(), self.handle, to, room, size)
                    })
                }
                /// Replaces the moving objects by those of a snapshot; any bytes are safe.
                pub fn restore(&mut self, snapshot: &[u8]) -> Result<()> {
                    check(unsafe {
                        scene_restore(self.at(), self.handle, snapshot.as_ptr().cast(),
                                      length(snapshot)?)
                    })
                    .map(|_| ())
                }
            }

            impl Drop for Scene<'_> {
                fn drop(&mut self) {
                    unsafe { scene_destroy(self.at(), self.handle) };
                }
            }

            /// The default options of a body.
            pub fn default_options() -> BodyOptions {
                let mut own = BodyOptions::default();
                unsafe { body_default_options(&mut own) };
                own
            }
            /// The default settings of a world.
            pub fn default_settings() -> WorldSettings {
                let mut own = WorldSettings::default();
                unsafe { world_default_settings(&mut own) };
                own
            }

            /// Bodies that fall, collide and come to rest. Destroyed on drop.
            pub struct World<'a> {
                context: &'a Context,
                handle: u32,
                not_sync: PhantomData<*mut ()>,
            }

            impl<'a> World<'a> {
                /// An empty world, with settings such as `default_settings()`.
                pub fn new(context: &'a Context, settings: &WorldSettings) -> Result<World<'a>> {
                    let mut handle = 0;
                    check(unsafe { world_create(context.pointer(), settings, &mut handle) })?;
                    Ok(World { context, handle, not_sync: PhantomData })
                }
                fn at(&self) -> *mut ffi::Context {
                    self.context.pointer()
                }
                /// Adds a sphere, AABB, OBB, capsule, or something `placed`: a solid hull, a
                /// compound or, in 3D, a mesh or height field.
                pub fn add(&mut self, shape: &Shape, options: &BodyOptions) -> Result<Id> {
                    let mut id = Id::default();
                    check(unsafe { world_add(self.at(), self.handle, shape, options, &mut id) })?;
                    Ok(id)
                }
                /// Joins two bodies; `None` if one does not exist.
                pub fn add_joint(&mut self, joint: &Joint) -> Result<Option<Id>> {
                    let mut id = Id::default();
                    let done = check(unsafe {
                        world_add_joint(self.at(), self.handle, joint, &mut id)
                    })?;
                    Ok(if done { Some(id) } else { None })
                }
                /// Replaces a joint by another of the same kind, such as one with another motor.
                pub fn change_joint(&mut self, id: Id, joint: &Joint) -> Result<bool> {
                    check(unsafe { world_change_joint(self.at(), self.handle, id, joint) })
                }
                /// Removes a joint; false if no joint has this id.
                pub fn remove_joint(&mut self, id: Id) -> Result<bool> {
                    check(unsafe { world_remove_joint(self.at(), self.handle, id) })
                }
                /// The fields of a joint.
                pub fn joint(&self, id: Id) -> Result<Option<Joint>> {
                    let mut joint = Joint::default();
                    let yes = check(unsafe { world_joint(self.at(), self.handle, id, &mut joint) })?;
                    Ok(if yes { Some(joint) } else { None })
                }
                /// The force of a joint on its body b in the last step.
                pub fn joint_force(&self, id: Id) -> Result<Option<[i32; $n]>> {
                    let mut force = ffi::$Vec::default();
                    let yes = check(unsafe {
                        world_joint_force(self.at(), self.handle, id, &mut force)
                    })?;
                    Ok(if yes { Some([$(force.$x),*]) } else { None })
                }
                /// The torque of a joint on its body b in the last step.
                pub fn joint_torque(&self, id: Id) -> Result<Option<[i32; $spin]>> {
                    let mut torque = [0; $spin];
                    let yes = check(unsafe {
                        world_joint_torque(self.at(), self.handle, id, torque.as_mut_ptr())
                    })?;
                    Ok(if yes { Some(torque) } else { None })
                }
                /// The ids of all joints.
                pub fn joint_ids(&self) -> Result<Vec<Id>> {
                    list(|to, room, count| unsafe {
                        world_joint_ids(self.at(), self.handle, to, room, count)
                    })
                }
                /// The joints that broke in the last step.
                pub fn broken(&self) -> Result<Vec<Id>> {
                    list(|to, room, count| unsafe {
                        world_broken(self.at(), self.handle, to, room, count)
                    })
                }
                /// Converts a world point to a body's frame, for the anchor of a joint.
                pub fn local_point(&self, id: Id, point: [i32; $n]) -> Result<Option<[i32; $n]>> {
                    let mut local = ffi::$Vec::default();
                    let yes = check(unsafe {
                        world_local_point(self.at(), self.handle, id, &vec(point), &mut local)
                    })?;
                    Ok(if yes { Some([$(local.$x),*]) } else { None })
                }
                /// Removes a body; false if no body has this id.
                pub fn remove(&mut self, id: Id) -> Result<bool> {
                    check(unsafe { world_remove(self.at(), self.handle, id) })
                }
                /// Simulates one tick.
                pub fn step(&mut self) -> Result<()> {
                    check(unsafe { world_step(self.at(), self.handle) }).map(|_| ())
                }
                /// The state of a body.
                pub fn body(&self, id: Id) -> Result<Option<Body>> {
                    let mut body = Body::default();
                    let yes = check(unsafe { world_body(self.at(), self.handle, id, &mut body) })?;
                    Ok(if yes { Some(body) } else { None })
                }
                /// The position of a body.
                pub fn position(&self, id: Id) -> Result<Option<[i32; $n]>> {
                    Ok(self.body(id)?.map(|body| [$(body.position.$x),*]))
                }
                /// The ids of all bodies.
                pub fn body_ids(&self) -> Result<Vec<Id>> {
                    list(|to, room, count| unsafe {
                        world_body_ids(self.at(), self.handle, to, room, count)
                    })
                }
                /// The properties of a body.
                pub fn info(&self, id: Id) -> Result<Option<ffi::BodyInfo>> {
                    let mut info = ffi::BodyInfo::default();
                    let yes = check(unsafe { world_info(self.at(), self.handle, id, &mut info) })?;
                    Ok(if yes { Some(info) } else { None })
                }
                /// The body and part of an object of a scene that follows this world.
                pub fn part_of(&self, object: Id) -> Result<Option<(Id, u32)>> {
                    let (mut body, mut part) = (Id::default(), 0);
                    let yes = check(unsafe {
                        world_part_of(self.at(), self.handle, object, &mut body, &mut part)
                    })?;
                    Ok(if yes { Some((body, part)) } else { None })
                }
                /// Puts a body elsewhere at once; it keeps its joints. False if no body has this id.
                pub fn set_position(&mut self, id: Id, position: [i32; $n]) -> Result<bool> {
                    check(unsafe { world_set_position(self.at(), self.handle, id, &vec(position)) })
                }
                /// Turns a body about its center at once; it keeps its joints.
                pub fn set_rotation(&mut self, id: Id, axes: [[i32; $n]; $n]) -> Result<bool> {
                    check(unsafe {
                        world_set_rotation(self.at(), self.handle, id, &rotation(axes))
                    })
                }
                /// Sets the layers of a body and those it collides with. False if no body has this id.
                pub fn set_filter(&mut self, id: Id, layers: u32, collides_with: u32) -> Result<bool> {
                    check(unsafe {
                        world_set_filter(self.at(), self.handle, id, layers, collides_with)
                    })
                }
                /// Sets the friction of a body, in steps of 2^-16.
                pub fn set_friction(&mut self, id: Id, friction: i32) -> Result<bool> {
                    check(unsafe { world_set_friction(self.at(), self.handle, id, friction) })
                }
                /// Sets the restitution of a body, in steps of 2^-16.
                pub fn set_restitution(&mut self, id: Id, restitution: i32) -> Result<bool> {
                    check(unsafe { world_set_restitution(self.at(), self.handle, id, restitution) })
                }
                /// Makes a body a sensor or solid.
                pub fn set_sensor(&mut self, id: Id, is_sensor: bool) -> Result<bool> {
                    check(unsafe { world_set_sensor(self.at(), self.handle, id, is_sensor as u32) })
                }
                /// Sets a body's factor on the world's gravity, in steps of 2^-16.
                pub fn set_gravity_scale(&mut self, id: Id, scale: i32) -> Result<bool> {
                    check(unsafe { world_set_gravity_scale(self.at(), self.handle, id, scale) })
                }
                /// Sets the damping of a body's velocity and of its spin, in steps of 2^-16.
                pub fn set_damping(&mut self, id: Id, linear: i32, angular: i32) -> Result<bool> {
                    check(unsafe {
                        world_set_damping(self.at(), self.handle, id, linear, angular)
                    })
                }
                /// Sets the locked axes of a body: `ffi::LOCK_X` and so on.
                pub fn set_locked(&mut self, id: Id, locked: u32) -> Result<bool> {
                    check(unsafe { world_set_locked(self.at(), self.handle, id, locked) })
                }
                /// Makes a body fast or not.
                pub fn set_fast(&mut self, id: Id, is_fast: bool) -> Result<bool> {
                    check(unsafe { world_set_fast(self.at(), self.handle, id, is_fast as u32) })
                }
                /// Sets the user word of a body; wakes nothing.
                pub fn set_user(&mut self, id: Id, user: u64) -> Result<bool> {
                    check(unsafe { world_set_user(self.at(), self.handle, id, user) })
                }
                /// Sets the gravity of the world and wakes all bodies.
                pub fn set_gravity(&mut self, gravity: [i32; $n]) -> Result<()> {
                    check(unsafe { world_set_gravity(self.at(), self.handle, &vec(gravity)) })
                        .map(|_| ())
                }
                /// Sets the velocity of a body and wakes it.
                pub fn set_velocity(&mut self, id: Id, velocity: [i32; $n]) -> Result<bool> {
                    check(unsafe { world_set_velocity(self.at(), self.handle, id, &vec(velocity)) })
                }
                /// Sets the angular velocity of a body and wakes it.
                pub fn set_angular_velocity(&mut self, id: Id, velocity: [i32; $spin]) -> Result<bool> {
                    check(unsafe {
                        world_set_angular_velocity(self.at(), self.handle, id, velocity.as_ptr())
                    })
                }
                /// Applies an impulse at a world point, or at the center of mass.
                pub fn apply_impulse(
                    &mut self,
                    id: Id,
                    impulse: [i32; $n],
                    at: Option<[i32; $n]>,
                ) -> Result<bool> {
                    let point = at.map(vec);
                    let point = point.as_ref().map_or(std::ptr::null(), |p| p as *const _);
                    check(unsafe {
                        world_apply_impulse(self.at(), self.handle, id, &vec(impulse), point)
                    })
                }
                /// Applies a force during the next step, otherwise like an impulse.
                pub fn apply_force(
                    &mut self,
                    id: Id,
                    force: [i32; $n],
                    at: Option<[i32; $n]>,
                ) -> Result<bool> {
                    let point = at.map(vec);
                    let point = point.as_ref().map_or(std::ptr::null(), |p| p as *const _);
                    check(unsafe {
                        world_apply_force(self.at(), self.handle, id, &vec(force), point)
                    })
                }
                /// Applies a torque during the next step.
                pub fn apply_torque(&mut self, id: Id, torque: [i32; $spin]) -> Result<bool> {
                    check(unsafe {
                        world_apply_torque(self.at(), self.handle, id, torque.as_ptr())
                    })
                }
                /// The number of bodies.
                pub fn size(&self) -> Result<u32> {
                    let mut size = 0;
                    check(unsafe { world_size(self.at(), self.handle, &mut size) })?;
                    Ok(size)
                }
                /// The frame in which a compound's parts or a hull's points were given.
                pub fn frame(&self, id: Id) -> Result<Option<Transform>> {
                    let mut frame = Transform::default();
                    let yes = check(unsafe {
                        world_frame(self.at(), self.handle, id, &mut frame)
                    })?;
                    Ok(if yes { Some(frame) } else { None })
                }
                /// The pairs that touch, of one body or, for `Id::default()`, of all.
                pub fn touching(&self, body: Id) -> Result<Vec<Touch>> {
                    list(|to, room, count| unsafe {
                        world_touching(self.at(), self.handle, body, to, room, count)
                    })
                }
                /// The contacts that touch, of one body or, for `Id::default()`, of all; none of
                /// sensors. The first `count` of their points are set.
                pub fn contacts(&self, body: Id) -> Result<Vec<WorldContact>> {
                    list(|to, room, count| unsafe {
                        world_contacts(self.at(), self.handle, body, to, room, count)
                    })
                }
                /// The pairs that began or ceased to touch in the last step.
                pub fn events(&self) -> Result<Vec<Touch>> {
                    list(|to, room, count| unsafe {
                        world_events(self.at(), self.handle, to, room, count)
                    })
                }
                /// A 64-bit digest of all bodies that are not fixed, and their contacts.
                pub fn digest(&self) -> Result<u64> {
                    let mut digest = 0;
                    check(unsafe { world_digest(self.at(), self.handle, &mut digest) })?;
                    Ok(digest)
                }
                /// The bodies that are not fixed as bytes.
                pub fn snapshot(&self) -> Result<Vec<u8>> {
                    bytes(|to, room, size| unsafe {
                        world_snapshot(self.at(), self.handle, to, room, size)
                    })
                }
                /// Restores a snapshot; any bytes are safe.
                pub fn restore(&mut self, snapshot: &[u8]) -> Result<()> {
                    check(unsafe {
                        world_restore(self.at(), self.handle, snapshot.as_ptr().cast(),
                                      length(snapshot)?)
                    })
                    .map(|_| ())
                }
            }

            impl<'a> World<'a> {
                /// The world of a session or replay, which owns it.
                fn owned(context: &'a Context, handle: u32) -> World<'a> {
                    World { context, handle, not_sync: PhantomData }
                }
                /// The names of the first `most` fields in which two worlds differ, such as
                /// `body 3:17 (sphere) velocity.y`.
                pub fn diff(&self, other: &World, most: u32) -> Result<Vec<String>> {
                    let names = bytes(|to, room, size| unsafe {
                        world_diff(self.at(), self.handle, other.handle, most, to, room, size)
                    })?;
                    Ok(String::from_utf8_lossy(&names).lines().map(String::from).collect())
                }
                /// The words next to the world of a session or replay; their number is in the
                /// settings.
                pub fn words(&self) -> Result<[u32; 256]> {
                    let mut words = [0; 256];
                    check(unsafe { world_words(self.at(), self.handle, words.as_mut_ptr()) })?;
                    Ok(words)
                }
                /// Sets the words, during a frame.
                pub fn set_words(&mut self, words: &[u32; 256]) -> Result<()> {
                    check(unsafe { world_set_words(self.at(), self.handle, words.as_ptr()) }).map(|_| ())
                }
            }

            impl Drop for World<'_> {
                fn drop(&mut self) {
                    unsafe { world_destroy(self.at(), self.handle) };
                }
            }

            /// A network match from a world that all peers start with.
            pub struct Session<'a> {
                world: World<'a>,
                handle: u32,
                input_size: usize,
            }

            impl<'a> Session<'a> {
                /// A session that begins with a copy of `start`.
                pub fn new(start: &World<'a>, settings: &SessionSettings) -> Result<Session<'a>> {
                    let (context, mut handle, mut world) = (start.context, 0, 0);
                    check(unsafe {
                        session_create(context.pointer(), settings, start.handle, &mut handle)
                    })?;
                    check(unsafe { session_world(context.pointer(), handle, &mut world) })?;
                    let world = World::owned(context, world);
                    Ok(Session { world, handle, input_size: settings.input_size as usize })
                }
                fn at(&self) -> *mut ffi::Context {
                    self.world.at()
                }
                /// The world after the last simulated frame.
                pub fn world(&self) -> &World<'a> {
                    &self.world
                }
                /// Calls `simulate` for all frames that are due: again for those whose inputs were
                /// mispredicted, then for the next one, with this input. Returns why there are no
                /// more, such as `ffi::PLAYED`. A frame for which `simulate` fails is played again.
                pub fn advance(
                    &mut self,
                    pad: &[u8],
                    mut simulate: impl FnMut(&mut World<'a>, &Frame) -> Result<()>,
                ) -> Result<u32> {
                    if pad.len() != self.input_size {
                        return Err(Error(ffi::BAD_ARGUMENT));
                    }
                    let mut frame = Frame::new(self.input_size);
                    while check(unsafe {
                        session_begin_frame(self.at(), self.handle, pad.as_ptr().cast(),
                                            &mut frame.frame, frame.inputs.as_mut_ptr().cast())
                    })? {
                        simulate(&mut self.world, &frame)?;
                        check(unsafe { session_end_frame(self.at(), self.handle) })?;
                    }
                    Ok(frame.frame.state)
                }
                /// Takes a packet that arrived at a time in microseconds; false if it was not used.
                pub fn receive(&mut self, peer: u32, packet: &[u8], now: u64) -> Result<bool> {
                    check(unsafe {
                        session_receive(self.at(), self.handle, peer, packet.as_ptr().cast(),
                                        length(packet)?, now)
                    })
                }
                /// Calls `send` with peer and packet for every packet that is due.
                pub fn poll(&mut self, now: u64, mut send: impl FnMut(u32, &[u8])) -> Result<()> {
                    let mut room = [0; ffi::PACKET as usize];
                    let (mut peer, mut size) = (0, 0);
                    while check(unsafe {
                        session_packet(self.at(), self.handle, now, &mut peer,
                                       room.as_mut_ptr().cast(), ffi::PACKET, &mut size)
                    })? {
                        send(peer, &room[..size as usize]);
                    }
                    Ok(())
                }
                /// The next event.
                pub fn event(&mut self) -> Result<Option<Event>> {
                    let mut event = ffi::SessionEvent::default();
                    let mut name = [0u8; ffi::NAME as usize];
                    let yes = check(unsafe {
                        session_event(self.at(), self.handle, &mut event, name.as_mut_ptr().cast(),
                                      ffi::NAME)
                    })?;
                    Ok(if yes {
                        let field = &name[..event.name_size as usize];
                        Some(Event {
                            kind: event.kind,
                            peer: event.peer,
                            frame: event.frame,
                            field: String::from_utf8_lossy(field).into_owned(),
                            object: if event.has_object != 0 { Some(event.object) } else { None },
                        })
                    } else {
                        None
                    })
                }
                /// The progress.
                pub fn status(&self) -> Result<SessionStatus> {
                    let mut status = SessionStatus::default();
                    check(unsafe { session_status(self.at(), self.handle, &mut status) })?;
                    Ok(status)
                }
                /// The number of frames known to be equal at the peer and here.
                pub fn matched(&self, peer: u32) -> Result<u32> {
                    let mut frame = 0;
                    check(unsafe { session_matched(self.at(), self.handle, peer, &mut frame) })?;
                    Ok(frame)
                }
                /// Whether the session waits for this player.
                pub fn is_awaited(&self, player: u32) -> Result<bool> {
                    check(unsafe { session_is_awaited(self.at(), self.handle, player) })
                }
                /// Continues without a peer.
                pub fn drop_peer(&mut self, peer: u32) -> Result<()> {
                    check(unsafe { session_drop(self.at(), self.handle, peer) }).map(|_| ())
                }
                /// Pauses or resumes.
                pub fn pause(&mut self, is_paused: bool) -> Result<()> {
                    check(unsafe { session_pause(self.at(), self.handle, is_paused as u32) }).map(|_| ())
                }
                /// The replay of all final frames; empty if none is recorded (`replay_every`).
                pub fn replay(&self) -> Result<Vec<u8>> {
                    bytes(|to, room, size| unsafe {
                        session_replay(self.at(), self.handle, to, room, size)
                    })
                }
            }

            impl Drop for Session<'_> {
                fn drop(&mut self) {
                    unsafe { session_destroy(self.at(), self.handle) };
                }
            }

            /// A replay to resimulate.
            pub struct Replay<'a> {
                world: World<'a>,
                handle: u32,
                input_size: usize,
            }

            impl<'a> Replay<'a> {
                /// A replay that begins in `start`, with the inputs and words of its session.
                pub fn new(start: &World<'a>, data: &[u8], input_size: u32, words: u32)
                           -> Result<Replay<'a>> {
                    let (context, mut handle, mut world) = (start.context, 0, 0);
                    check(unsafe {
                        replay_create(context.pointer(), data.as_ptr().cast(), length(data)?,
                                      start.handle, input_size, words, &mut handle)
                    })?;
                    check(unsafe { replay_world(context.pointer(), handle, &mut world) })?;
                    let world = World::owned(context, world);
                    Ok(Replay { world, handle, input_size: input_size as usize })
                }
                fn at(&self) -> *mut ffi::Context {
                    self.world.at()
                }
                /// Calls `simulate` for all frames, up to the first digest that differs.
                pub fn play(
                    &mut self,
                    mut simulate: impl FnMut(&mut World<'a>, &Frame) -> Result<()>,
                ) -> Result<ReplayCheck> {
                    let mut frame = Frame::new(self.input_size);
                    while check(unsafe {
                        replay_begin_frame(self.at(), self.handle, &mut frame.frame,
                                           frame.inputs.as_mut_ptr().cast())
                    })? {
                        simulate(&mut self.world, &frame)?;
                        check(unsafe { replay_end_frame(self.at(), self.handle) })?;
                    }
                    let mut given = ReplayCheck::default();
                    check(unsafe { replay_check(self.at(), self.handle, &mut given) })?;
                    Ok(given)
                }
            }

            impl Drop for Replay<'_> {
                fn drop(&mut self) {
                    unsafe { replay_destroy(self.at(), self.handle) };
                }
            }
        }
    };
}

space! {
    d2, "Shapes, rays, scenes and worlds in 2D.", 2, 1, [0 x, 1 y],
    Vec2 Direction2 Rotation2 Transform2 Ray2 Shape2
    Shape2As Hit2 ObjectHit2 World2Settings Body2Options Body2
    Sphere2 Aabb2 Obb2 Plane2 Triangle2 Capsule2
    Segment2 ContactPoint2 Manifold2 Sweep2 Joint2 World2Contact
    Mover2 Mover2Settings Move2 Part2;
    raycast_ = detent_raycast2,
    raycast_many_ = detent_raycast2_many,
    contains_ = detent_contains2,
    overlaps_ = detent_overlaps2,
    closest_point_ = detent_closest_point2,
    distance_to_point_ = detent_distance_to_point2,
    distance_ = detent_distance2,
    contact_ = detent_contact2,
    scene_cast = detent_scene2_cast,
    scene_cast_any = detent_scene2_cast_any,
    scene_cast_all = detent_scene2_cast_all,
    mover_move = detent_mover2_move,
    mover_default_settings = detent_mover2_default_settings,
    mover_clip_velocity = detent_mover2_clip_velocity,
    closest_points_ = detent_closest_points2,
    cast_ = detent_cast2,
    time_of_impact_ = detent_time_of_impact2,
    joint_defaults = detent_joint2_defaults,
    solid_create = detent_solid2_create,
    part_defaults = detent_part2_defaults,
    compound_create = detent_compound2_create,
    world_add_joint = detent_world2_add_joint,
    world_change_joint = detent_world2_change_joint,
    world_remove_joint = detent_world2_remove_joint,
    world_joint = detent_world2_joint,
    world_broken = detent_world2_broken,
    world_local_point = detent_world2_local_point,
    world_joint_force = detent_world2_joint_force,
    world_joint_torque = detent_world2_joint_torque,
    scene_add_frame = detent_scene2_add_frame,
    scene_move_frame = detent_scene2_move_frame,
    scene_remove_frame = detent_scene2_remove_frame,
    scene_create = detent_scene2_create,
    scene_destroy = detent_scene2_destroy,
    scene_add = detent_scene2_add,
    scene_remove = detent_scene2_remove,
    scene_replace = detent_scene2_replace,
    scene_move = detent_scene2_move,
    scene_optimize = detent_scene2_optimize,
    scene_follow = detent_scene2_follow,
    scene_size = detent_scene2_size,
    scene_raycast = detent_scene2_raycast,
    scene_raycast_any = detent_scene2_raycast_any,
    scene_raycast_all = detent_scene2_raycast_all,
    scene_raycast_many = detent_scene2_raycast_many,
    scene_nearest = detent_scene2_nearest,
    scene_any = detent_scene2_any,
    scene_all = detent_scene2_all,
    scene_overlaps = detent_scene2_overlaps,
    scene_digest = detent_scene2_digest,
    scene_snapshot = detent_scene2_snapshot,
    scene_restore = detent_scene2_restore,
    world_create = detent_world2_create,
    world_destroy = detent_world2_destroy,
    world_add = detent_world2_add,
    world_remove = detent_world2_remove,
    world_step = detent_world2_step,
    world_body = detent_world2_body,
    world_body_ids = detent_world2_body_ids,
    world_info = detent_world2_info,
    world_joint_ids = detent_world2_joint_ids,
    world_part_of = detent_world2_part_of,
    world_set_position = detent_world2_set_position,
    world_set_rotation = detent_world2_set_rotation,
    world_touching = detent_world2_touching,
    world_contacts = detent_world2_contacts,
    world_set_filter = detent_world2_set_filter,
    world_set_friction = detent_world2_set_friction,
    world_set_restitution = detent_world2_set_restitution,
    world_set_sensor = detent_world2_set_sensor,
    world_set_gravity_scale = detent_world2_set_gravity_scale,
    world_set_damping = detent_world2_set_damping,
    world_set_locked = detent_world2_set_locked,
    world_set_fast = detent_world2_set_fast,
    world_set_user = detent_world2_set_user,
    world_set_gravity = detent_world2_set_gravity,
    world_set_velocity = detent_world2_set_velocity,
    world_set_angular_velocity = detent_world2_set_angular_velocity,
    world_apply_impulse = detent_world2_apply_impulse,
    world_apply_force = detent_world2_apply_force,
    world_apply_torque = detent_world2_apply_torque,
    world_size = detent_world2_size,
    world_events = detent_world2_events,
    world_frame = detent_world2_frame,
    world_digest = detent_world2_digest,
    world_snapshot = detent_world2_snapshot,
    world_restore = detent_world2_restore,
    world_default_settings = detent_world2_default_settings,
    body_default_options = detent_body2_default_options,
    world_diff = detent_world2_diff,
    world_words = detent_world2_words,
    world_set_words = detent_world2_set_words,
    session_create = detent_session2_create,
    session_destroy = detent_session2_destroy,
    session_world = detent_session2_world,
    session_receive = detent_session2_receive,
    session_begin_frame = detent_session2_begin_frame,
    session_end_frame = detent_session2_end_frame,
    session_packet = detent_session2_packet,
    session_event = detent_session2_event,
    session_status = detent_session2_status,
    session_matched = detent_session2_matched,
    session_is_awaited = detent_session2_is_awaited,
    session_drop = detent_session2_drop,
    session_pause = detent_session2_pause,
    session_replay = detent_session2_replay,
    replay_create = detent_replay2_create,
    replay_destroy = detent_replay2_destroy,
    replay_world = detent_replay2_world,
    replay_begin_frame = detent_replay2_begin_frame,
    replay_end_frame = detent_replay2_end_frame,
    replay_check = detent_replay2_check,
    hull_create = detent_hull2_create,
}

space! {
    d3, "Shapes, rays, scenes and worlds in 3D.", 3, 3, [0 x, 1 y, 2 z],
    Vec3 Direction3 Rotation3 Transform3 Ray3 Shape3
    Shape3As Hit3 ObjectHit3 World3Settings Body3Options Body3
    Sphere3 Aabb3 Obb3 Plane3 Triangle3 Capsule3
    Segment3 ContactPoint3 Manifold3 Sweep3 Joint3 World3Contact
    Mover3 Mover3Settings Move3 Part3;
    raycast_ = detent_raycast3,
    raycast_many_ = detent_raycast3_many,
    contains_ = detent_contains3,
    overlaps_ = detent_overlaps3,
    closest_point_ = detent_closest_point3,
    distance_to_point_ = detent_distance_to_point3,
    distance_ = detent_distance3,
    contact_ = detent_contact3,
    scene_cast = detent_scene3_cast,
    scene_cast_any = detent_scene3_cast_any,
    scene_cast_all = detent_scene3_cast_all,
    mover_move = detent_mover3_move,
    mover_default_settings = detent_mover3_default_settings,
    mover_clip_velocity = detent_mover3_clip_velocity,
    closest_points_ = detent_closest_points3,
    cast_ = detent_cast3,
    time_of_impact_ = detent_time_of_impact3,
    joint_defaults = detent_joint3_defaults,
    solid_create = detent_solid3_create,
    part_defaults = detent_part3_defaults,
    compound_create = detent_compound3_create,
    world_add_joint = detent_world3_add_joint,
    world_change_joint = detent_world3_change_joint,
    world_remove_joint = detent_world3_remove_joint,
    world_joint = detent_world3_joint,
    world_broken = detent_world3_broken,
    world_local_point = detent_world3_local_point,
    world_joint_force = detent_world3_joint_force,
    world_joint_torque = detent_world3_joint_torque,
    scene_add_frame = detent_scene3_add_frame,
    scene_move_frame = detent_scene3_move_frame,
    scene_remove_frame = detent_scene3_remove_frame,
    scene_create = detent_scene3_create,
    scene_destroy = detent_scene3_destroy,
    scene_add = detent_scene3_add,
    scene_remove = detent_scene3_remove,
    scene_replace = detent_scene3_replace,
    scene_move = detent_scene3_move,
    scene_optimize = detent_scene3_optimize,
    scene_follow = detent_scene3_follow,
    scene_size = detent_scene3_size,
    scene_raycast = detent_scene3_raycast,
    scene_raycast_any = detent_scene3_raycast_any,
    scene_raycast_all = detent_scene3_raycast_all,
    scene_raycast_many = detent_scene3_raycast_many,
    scene_nearest = detent_scene3_nearest,
    scene_any = detent_scene3_any,
    scene_all = detent_scene3_all,
    scene_overlaps = detent_scene3_overlaps,
    scene_digest = detent_scene3_digest,
    scene_snapshot = detent_scene3_snapshot,
    scene_restore = detent_scene3_restore,
    world_create = detent_world3_create,
    world_destroy = detent_world3_destroy,
    world_add = detent_world3_add,
    world_remove = detent_world3_remove,
    world_step = detent_world3_step,
    world_body = detent_world3_body,
    world_body_ids = detent_world3_body_ids,
    world_info = detent_world3_info,
    world_joint_ids = detent_world3_joint_ids,
    world_part_of = detent_world3_part_of,
    world_set_position = detent_world3_set_position,
    world_set_rotation = detent_world3_set_rotation,
    world_touching = detent_world3_touching,
    world_contacts = detent_world3_contacts,
    world_set_filter = detent_world3_set_filter,
    world_set_friction = detent_world3_set_friction,
    world_set_restitution = detent_world3_set_restitution,
    world_set_sensor = detent_world3_set_sensor,
    world_set_gravity_scale = detent_world3_set_gravity_scale,
    world_set_damping = detent_world3_set_damping,
    world_set_locked = detent_world3_set_locked,
    world_set_fast = detent_world3_set_fast,
    world_set_user = detent_world3_set_user,
    world_set_gravity = detent_world3_set_gravity,
    world_set_velocity = detent_world3_set_velocity,
    world_set_angular_velocity = detent_world3_set_angular_velocity,
    world_apply_impulse = detent_world3_apply_impulse,
    world_apply_force = detent_world3_apply_force,
    world_apply_torque = detent_world3_apply_torque,
    world_size = detent_world3_size,
    world_events = detent_world3_events,
    world_frame = detent_world3_frame,
    world_digest = detent_world3_digest,
    world_snapshot = detent_world3_snapshot,
    world_restore = detent_world3_restore,
    world_default_settings = detent_world3_default_settings,
    body_default_options = detent_body3_default_options,
    world_diff = detent_world3_diff,
    world_words = detent_world3_words,
    world_set_words = detent_world3_set_words,
    session_create = detent_session3_create,
    session_destroy = detent_session3_destroy,
    session_world = detent_session3_world,
    session_receive = detent_session3_receive,
    session_begin_frame = detent_session3_begin_frame,
    session_end_frame = detent_session3_end_frame,
    session_packet = detent_session3_packet,
    session_event = detent_session3_event,
    session_status = detent_session3_status,
    session_matched = detent_session3_matched,
    session_is_awaited = detent_session3_is_awaited,
    session_drop = detent_session3_drop,
    session_pause = detent_session3_pause,
    session_replay = detent_session3_replay,
    replay_create = detent_replay3_create,
    replay_destroy = detent_replay3_destroy,
    replay_world = detent_replay3_world,
    replay_begin_frame = detent_replay3_begin_frame,
    replay_end_frame = detent_replay3_end_frame,
    replay_check = detent_replay3_check,
    hull_create = detent_hull3_create,
}
